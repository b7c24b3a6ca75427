// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/FirstSize.h"

namespace limn {

QSize firstWindowSize(const QSize& available) {
  constexpr QSize usual(1440, 900);
  constexpr int titleBar = 40; // the platform puts it around the window, and only once it is shown
  return (available * 0.8).expandedTo(usual).boundedTo(available - QSize(0, titleBar));
}

} // namespace limn
