// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/dialogs/WindowsAbove.h"

#include <QApplication>
#include <QEvent>
#include <QWindow>

namespace limn {

WindowsAbove::WindowsAbove(QWidget& window) : QObject(&window), m_window(window) {
  window.installEventFilter(this);
}

// Queued: it is told before the new one is shown.
bool WindowsAbove::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &m_window && event->type() == QEvent::WinIdChange) {
    const QPointer<QWidget> withKeyboard = QApplication::activeWindow();
    QMetaObject::invokeMethod(
        this, [this, withKeyboard] { raiseAll(withKeyboard); }, Qt::QueuedConnection);
  }
  return QObject::eventFilter(watched, event);
}

void WindowsAbove::raiseAll(const QPointer<QWidget>& withKeyboard) {
  for (QWidget* above : m_window.findChildren<QWidget*>()) {
    const bool isDialogOrPanel = above->windowType() == Qt::Dialog || above->windowType() == Qt::Tool;
    if (!isDialogOrPanel || !above->isVisible() || !above->windowHandle() ||
        above->parentWidget()->window() != &m_window)
      continue;
    above->windowHandle()->setTransientParent(m_window.windowHandle());
    above->raise();
    if (above == withKeyboard)
      above->activateWindow();
  }
}

} // namespace limn
