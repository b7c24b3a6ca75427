// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/LightDirections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

// At a height along the third axis.
glm::dvec3 directionAt(double height, double turn) {
  const double radius = std::sqrt(std::max(0.0, 1.0 - height * height));
  const double angle = 2.0 * std::numbers::pi * turn;
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

} // namespace

double lightOffsetMm(const Grid& grid) {
  return 1.5 * smallestSpacingMm(grid);
}

glm::dvec2 spreadPoint(int n) {
  constexpr double plastic = 1.32471795724474602596;
  return glm::fract(glm::dvec2(0.5) + double(n) * glm::dvec2(1.0 / plastic, 1.0 / (plastic * plastic)));
}

glm::dvec2 latticePoint(int n, int count) {
  return {(n + 0.5) / count, glm::fract(0.5 + n * (std::numbers::phi - 1.0))};
}

glm::dvec3 directionInCone(const glm::dvec2& point, double angleDeg) {
  const double half = std::sin(0.5 * glm::radians(angleDeg));
  return directionAt(1.0 - 2.0 * half * half * point.x, point.y); // 1 - cos, for small angles, too
}

glm::dvec3 directionByCosine(const glm::dvec2& point) {
  return directionAt(std::sqrt(point.x), point.y);
}

glm::dvec3 directionOnSphere(const glm::dvec2& point) {
  return directionAt(1.0 - 2.0 * point.x, point.y);
}

} // namespace limn
