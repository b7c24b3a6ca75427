// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/PopupPlacement.h"

#include <QScreen>
#include <QWidget>

#include <algorithm>

namespace limn {

void showPopupAt(QWidget& popup, const QRect& anchor) {
  popup.adjustSize();
  const QSize size = popup.sizeHint();
  const QRect screen = popup.screen()->availableGeometry();
  int y = anchor.bottom() + 4;
  if (y + size.height() > screen.bottom())
    y = anchor.top() - 4 - size.height();
  const int x =
      std::clamp(anchor.left(), screen.left(), std::max(screen.left(), screen.right() - size.width()));
  popup.move(x, std::max(screen.top(), y));
  popup.show();
}

} // namespace limn
