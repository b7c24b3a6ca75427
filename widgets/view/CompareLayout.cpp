// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/CompareLayout.h"

#include <algorithm>
#include <cmath>

namespace limn {

int pictureCount(CompareLayout layout) {
  return layout == CompareLayout::single ? 1 : 2;
}

std::vector<PixelRect> pictureRects(CompareLayout layout, const glm::ivec2& size, int gap) {
  if (size.y < 1)
    return {};
  if (layout == CompareLayout::sideBySide) {
    const int width = (size.x - gap) / 2;
    if (width < 1)
      return {};
    return {{{0, 0}, {width, size.y}}, {{size.x - width, 0}, {width, size.y}}};
  }
  if (size.x < 1)
    return {};
  return std::vector<PixelRect>(pictureCount(layout), PixelRect{{0, 0}, size});
}

int wipeColumn(int width, double fraction) {
  return static_cast<int>(std::lround(std::clamp(fraction, 0.0, 1.0) * width));
}

int pictureAt(CompareLayout layout, const glm::ivec2& size, double wipeFraction, double x) {
  switch (layout) {
  case CompareLayout::sideBySide:
    return x < 0.5 * size.x ? 0 : 1;
  case CompareLayout::wipe:
    return x < wipeColumn(size.x, wipeFraction) ? 0 : 1;
  case CompareLayout::single:
  case CompareLayout::difference:
    break;
  }
  return 0;
}

} // namespace limn
