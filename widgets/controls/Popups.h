// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QRect>
#include <QToolButton>

class QWidget;

namespace limn {

/// Where a pop-up of this size belongs to `anchor` without covering it: below, above, right or left, the
/// first that has room on `screen`. Where none has, it lies at the edge of the screen that is farther from
/// the anchor. All in one system of pixels.
QRect popupPlace(const QSize& size, const QRect& anchor, const QRect& screen);

/// Shows a pop-up there; `anchor` in global pixels.
void showPopupAt(QWidget& popup, const QRect& anchor);

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
