// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/bricks/Bricks.h"

#include <algorithm>

namespace limn {
namespace {

// Beyond every volume, and far enough from infinity to be divided by a direction.
constexpr double farAway = 1e30;

// Of axes of equal length the last: what lies together in a file stays together.
int longestAxis(const glm::dvec3& size) {
  int longest = 2;
  for (int axis = 1; axis >= 0; --axis)
    if (size[axis] > size[longest])
      longest = axis;
  return longest;
}

} // namespace

Bricks::Bricks(const Grid& grid, const CropBox& crop, int count) : m_boxes(static_cast<std::size_t>(count)) {
  divide(croppedBox(grid, crop), {glm::dvec3(-farAway), glm::dvec3(farAway)}, 0, count);
}

void Bricks::divide(const IndexBox& inner, const IndexBox& outer, int first, int count) {
  if (count == 1) {
    m_boxes[static_cast<std::size_t>(first)] = outer;
    return;
  }
  const int below = count / 2;
  const glm::dvec3 size = inner.upper - inner.lower;
  const int axis = longestAxis(size);
  const double plane = inner.lower[axis] + size[axis] * below / count;
  m_splits.push_back({first, below, count, axis, plane});
  IndexBox innerBelow = inner, innerAbove = inner, outerBelow = outer, outerAbove = outer;
  innerBelow.upper[axis] = innerAbove.lower[axis] = plane;
  outerBelow.upper[axis] = outerAbove.lower[axis] = plane;
  divide(innerBelow, outerBelow, first, below);
  divide(innerAbove, outerAbove, first + below, count - below);
}

std::vector<int> Bricks::frontToBack(const RayFrame& frame) const {
  // The middle ray's: where rays are parallel the direction of all, otherwise through the eye of all.
  const glm::dvec3 eye = frame.anchor - frame.anchorDistanceMm * frame.direction;
  const bool isParallel = frame.tangentPerPixel == 0.0;
  std::vector<int> order(m_boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = static_cast<int>(i);
  // The parts of a split lie side by side in the order whatever splits within them did, so that turning
  // them is swapping two runs; inner splits first.
  for (auto split = m_splits.rbegin(); split != m_splits.rend(); ++split) {
    const bool lowerIsNear =
        isParallel ? frame.direction[split->axis] > 0.0 : eye[split->axis] < split->plane;
    const auto begin = order.begin() + split->first;
    if (!lowerIsNear)
      std::rotate(begin, begin + split->below, begin + split->count);
  }
  return order;
}

} // namespace limn
