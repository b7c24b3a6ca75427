// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/LightGrid.h"

#include <algorithm>
#include <cmath>

namespace limn {

LightNodes lightNodes(const Grid& grid, const glm::dvec3& lower, const glm::dvec3& upper,
                      std::size_t bytesEach, std::size_t mostBytes) {
  const glm::dvec3 extent = upper - lower;
  if (glm::any(glm::lessThanEqual(extent, glm::dvec3(0.0))))
    return {};
  const glm::dvec3 sizeMm = extent * grid.spacingMm;
  LightNodes nodes;
  nodes.first = lower;
  const double most = static_cast<double>(mostBytes) / static_cast<double>(bytesEach);
  double distanceMm = std::max(smallestSpacingMm(grid), std::cbrt(sizeMm.x * sizeMm.y * sizeMm.z / most));
  for (;; distanceMm *= 1.02) {
    const glm::dvec3 count = glm::max(glm::ceil(sizeMm / distanceMm) + 1.0, glm::dvec3(2.0));
    nodes.count = glm::ivec3(count);
    if (count.x * count.y * count.z <= std::max(most, 8.0))
      break;
  }
  nodes.stride = extent / glm::dvec3(nodes.count - 1);
  return nodes;
}

} // namespace limn
