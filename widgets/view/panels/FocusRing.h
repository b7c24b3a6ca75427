// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace limn {

/// A line around a widget while it has the focus by Tab. A pointer that gives the focus shows where it is by
/// itself.
class FocusRing : public QWidget {
  Q_OBJECT

public:
  explicit FocusRing(QWidget* owner);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

/// Keys go to what the pointer is over, but not out of a field in which someone types.
void takeFocusUnderPointer(QWidget& view);

} // namespace limn
