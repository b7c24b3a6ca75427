// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/FirstSize.h"

#include <algorithm>

namespace limn {

QSize firstWindowSize(const QSize& available) {
  constexpr QSize usual(1440, 900);
  constexpr int titleBar = 40; // the platform puts it around the window, and only once it is shown
  return (available * 0.8).expandedTo(usual).boundedTo(available - QSize(0, titleBar));
}

FirstDockSizes firstDockSizes(const QSize& window) {
  constexpr int lowWindow = 800;
  return {std::min(window.width() / 8, 340), std::clamp(window.width() / 5, 300, 380),
          std::clamp(296 - (lowWindow - window.height()), 220, 296)};
}

} // namespace limn
