// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/FirstSize.h"

#include <algorithm>

namespace limn {
namespace {

constexpr int titleBar = 40; // the platform puts it around the window, and only once it is shown

} // namespace

QSize firstWindowSize(const QSize& available) {
  constexpr QSize usual(1440, 900);
  return (available * 0.8).expandedTo(usual).boundedTo(available - QSize(0, titleBar));
}

QRect withinScreen(QRect window, const QRect& available) {
  if (window.width() > available.width())
    window.setWidth(available.width());
  if (window.height() > available.height())
    window.setHeight(available.height() - titleBar);
  window.moveRight(std::min(window.right(), available.right()));
  window.moveBottom(std::min(window.bottom(), available.bottom()));
  window.moveLeft(std::max(window.left(), available.left()));
  window.moveTop(std::max(window.top(), available.top()));
  return window;
}

FirstDockSizes firstDockSizes(const QSize& window) {
  constexpr int lowWindow = 800;
  return {std::min(window.width() / 8, 340), std::clamp(window.width() / 5, 300, 380),
          std::clamp(296 - (lowWindow - window.height()), 220, 296)};
}

} // namespace limn
