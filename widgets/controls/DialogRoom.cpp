// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/DialogRoom.h"

#include <QDialog>
#include <QEvent>
#include <QScreen>
#include <QScrollBar>

#include <algorithm>

namespace limn {

// Of a window that was not shown yet nobody knows it.
static constexpr int titleBar = 40, sideFrame = 8;

void fitInto(QWidget& window, const QRect& available) {
  const QRect room = available.adjusted(sideFrame, titleBar, -sideFrame, -sideFrame);
  const QSize size = window.size().boundedTo(room.size());
  if (size != window.size())
    window.resize(size);
  if (!window.testAttribute(Qt::WA_Moved))
    return; // Qt finds a place for it
  const QPoint last = room.bottomRight() + QPoint(1, 1) - QPoint(window.width(), window.height());
  const QPoint place(std::max(room.left(), std::min(window.geometry().left(), last.x())),
                     std::max(room.top(), std::min(window.geometry().top(), last.y())));
  if (place != window.geometry().topLeft())
    window.setGeometry(QRect(place, window.size()));
}

bool DialogRoom::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show && !event->spontaneous())
    if (auto* dialog = qobject_cast<QDialog*>(watched))
      fitInto(*dialog, dialog->screen()->availableGeometry());
  return QObject::eventFilter(watched, event);
}

WholeScroll::WholeScroll(QWidget* content) {
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setWidget(content);
}

// With room beside its bar: lines that fold for that would keep it.
QSize WholeScroll::sizeHint() const {
  return widget()->sizeHint().expandedTo(widget()->minimumSize()) +
         QSize(verticalScrollBar()->sizeHint().width(), 0);
}

} // namespace limn
