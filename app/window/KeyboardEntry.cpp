// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/KeyboardEntry.h"

#include <QWidget>

namespace limn {

bool takesKeys(const QWidget& widget) {
  return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::TabFocus) != 0;
}

QWidget* keyboardEntryOf(QWidget& area) {
  QWidget* proxy = area.focusProxy();
  while (proxy && proxy->focusProxy())
    proxy = proxy->focusProxy();
  if (proxy && takesKeys(*proxy))
    return proxy;
  QWidget* next = &area;
  do {
    if ((next == &area || area.isAncestorOf(next)) && takesKeys(*next))
      return next;
    next = next->nextInFocusChain();
  } while (next != &area);
  return nullptr;
}

} // namespace limn
