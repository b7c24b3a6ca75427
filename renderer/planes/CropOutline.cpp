// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/CropOutline.h"

#include <algorithm>
#include <cmath>

namespace limn {

std::vector<glm::dvec3> cropOutline(const Grid& volume, const CropBox& crop, const PlaneGrid& plane) {
  if (crop == CropBox{})
    return {};
  const glm::dvec3 dims(volume.dims);
  const auto corner = [&](int which) {
    const glm::bvec3 isUpper(which & 1, which & 2, which & 4);
    return indexToWorld(volume, glm::mix(crop.lower, crop.upper, isUpper) * dims - 0.5);
  };
  const auto heightOf = [&](const glm::dvec3& place) {
    return glm::dot(place - plane.originMm, plane.axes.forward);
  };
  std::vector<glm::dvec3> crossings;
  for (int from = 0; from < 8; ++from)
    for (const int axis : {1, 2, 4}) {
      if (from & axis)
        continue;
      const glm::dvec3 a = corner(from);
      const glm::dvec3 b = corner(from | axis);
      // A face that lies in the plane belongs to the side above it.
      if ((heightOf(a) >= 0.0) != (heightOf(b) >= 0.0))
        crossings.push_back(glm::mix(a, b, heightOf(a) / (heightOf(a) - heightOf(b))));
    }
  // A cut through a box is convex.
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& place : crossings)
    middle += place / static_cast<double>(crossings.size());
  const auto angleOf = [&](const glm::dvec3& place) {
    return std::atan2(glm::dot(place - middle, plane.axes.down), glm::dot(place - middle, plane.axes.right));
  };
  std::ranges::sort(crossings, {}, angleOf);
  return crossings;
}

} // namespace limn
