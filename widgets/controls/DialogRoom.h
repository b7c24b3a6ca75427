// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QScrollArea>

namespace limn {

/// Makes a window that is larger than the room it has as large as that, and moves one that has a place into
/// it; both with its frame.
void fitInto(QWidget& window, const QRect& available);

/// Fits every dialog of the program into its screen as it is shown, before it is seen. Where less is left
/// than its parts need, they have to scroll.
class DialogRoom : public QObject {
public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override;
};

/// Scrolls what finds no room in a dialog, and asks for room for all of it.
class WholeScroll : public QScrollArea {
public:
  /// `content` becomes its own.
  explicit WholeScroll(QWidget* content);

  QSize sizeHint() const override;
};

} // namespace limn
