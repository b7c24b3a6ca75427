// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/FirstView.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace limn {
namespace {

int largestComponent(const glm::dvec3& v) {
  const glm::dvec3 size = glm::abs(v);
  return size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
}

// The index axis along which a box is much thinner than along both others.
std::optional<int> thinAxis(const Grid& grid) {
  constexpr double muchThinner = 1.0 / 3.0;
  const glm::dvec3 size = boxSizeMm(grid);
  for (int i = 0; i < 3; ++i)
    if (size[i] < muchThinner * std::min(size[(i + 1) % 3], size[(i + 2) % 3]))
      return i;
  return std::nullopt;
}

// The direction of an axis of the slice, towards the side on which `wanted` lies.
glm::dvec3 towards(const glm::dvec3& axis, const glm::dvec3& wanted) {
  return glm::dot(axis, wanted) < 0.0 ? -axis : axis;
}

} // namespace

Camera firstView(const Camera& camera, const Grid& grid, bool orientationKnown) {
  Camera placed = standardView(camera, grid, StandardView::anterior);
  std::optional<int> flat = imageNormalAxis(grid);
  if (!flat && !orientationKnown)
    flat = thinAxis(grid);
  if (!flat)
    return placed;
  // LPS: +x is the patient's left, +y posterior, +z superior.
  constexpr glm::dvec3 lookedFrom[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  constexpr glm::dvec3 upwards[] = {{0, 0, 1}, {0, 0, 1}, {0, -1, 0}};
  const glm::dvec3 normal = grid.direction[*flat];
  const int plane = largestComponent(normal);
  const double distance = glm::length(placed.position - placed.target);
  placed.position = placed.target + distance * towards(normal, lookedFrom[plane]);
  // Along the side of the slice that points up most: a tilted slice still stands upright.
  const glm::dvec3 rows = grid.direction[(*flat + 1) % 3];
  const glm::dvec3 columns = grid.direction[(*flat + 2) % 3];
  const glm::dvec3& up = upwards[plane];
  placed.up = towards(std::abs(glm::dot(rows, up)) > std::abs(glm::dot(columns, up)) ? rows : columns, up);
  return placed;
}

} // namespace limn
