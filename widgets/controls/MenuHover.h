// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QToolButton>

namespace limn {

/// Lets a button look idle once its menu is closed: the pointer may have left it meanwhile, which Qt tells
/// nobody while a menu holds the mouse.
inline void looksIdleAfterMenu(QToolButton& button) {
  QObject::connect(
      button.menu(), &QMenu::aboutToHide, &button,
      [&button] {
        button.setAttribute(Qt::WA_UnderMouse, false);
        button.update();
      },
      Qt::QueuedConnection);
}

} // namespace limn
