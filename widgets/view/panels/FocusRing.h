// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace limn {

/// A line around a widget while it has the focus by a key. A pointer that gives the focus shows where it is
/// by itself.
class FocusRing : public QWidget {
  Q_OBJECT

public:
  explicit FocusRing(QWidget* owner);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

/// Gives the focus to a widget that tracks the pointer once that moves into it, but not out of a field in
/// which someone types. A pointer that rests where a dialog was takes nothing from what the dialog led to.
class PointerFocus : public QObject {
  Q_OBJECT

public:
  explicit PointerFocus(QWidget* owner);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool m_hasEntered = false; ///< and not moved since
};

} // namespace limn
