// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QMouseEvent>

namespace limn {

/// How wide the names in a panel are: behind them tracks and boxes begin, all at one place.
inline constexpr int labelColumn = 116;

/// The name of a control; a double click asks for the default.
class ResetLabel : public QLabel {
  Q_OBJECT

public:
  using QLabel::QLabel;

signals:
  void resetRequested();

protected:
  void mouseDoubleClickEvent(QMouseEvent* event) override {
    if (event->button() == Qt::LeftButton)
      emit resetRequested();
  }
};

} // namespace limn
