// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/Popups.h"

#include <QGuiApplication>
#include <QScreen>
#include <QWidget>

#include <algorithm>

namespace limn {
namespace {

constexpr int popupGap = 4;

// The start of a length that begins at `wanted` where that keeps it on the screen.
int keptWithin(int wanted, int length, int first, int last) {
  return std::max(first, std::min(wanted, last + 1 - length));
}

} // namespace

QRect popupPlace(const QSize& size, const QRect& anchor, const QRect& screen) {
  const int x = keptWithin(anchor.left(), size.width(), screen.left(), screen.right());
  const int y = keptWithin(anchor.top(), size.height(), screen.top(), screen.bottom());
  const int below = anchor.bottom() + 1 + popupGap;
  const int above = anchor.top() - popupGap - size.height();
  const int right = anchor.right() + 1 + popupGap;
  const int left = anchor.left() - popupGap - size.width();
  for (const QPoint& corner : {QPoint(x, below), QPoint(x, above), QPoint(right, y), QPoint(left, y)})
    if (screen.contains(QRect(corner, size)))
      return {corner, size};
  const bool isUpper = anchor.center().y() < screen.center().y();
  return {QPoint(x, isUpper ? keptWithin(screen.bottom(), size.height(), screen.top(), screen.bottom())
                            : screen.top()),
          size};
}

void showPopupAt(QWidget& popup, const QRect& anchor) {
  popup.adjustSize();
  const QScreen* under = QGuiApplication::screenAt(anchor.center());
  const QScreen& screen = under ? *under : *popup.screen();
  popup.move(popupPlace(popup.sizeHint(), anchor, screen.availableGeometry()).topLeft());
  popup.show();
}

} // namespace limn
