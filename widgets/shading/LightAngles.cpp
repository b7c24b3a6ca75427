// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/LightAngles.h"

#include <algorithm>
#include <cmath>

namespace limn {

glm::dvec3 travelDirection(const LightAngles& angles) {
  const double azimuth = glm::radians(angles.azimuthDeg);
  const double elevation = glm::radians(angles.elevationDeg);
  // In LPS +x is left, +y posterior, +z superior.
  const glm::dvec3 from(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                        std::sin(elevation));
  return -from;
}

LightAngles lightAngles(const glm::dvec3& travelDirection) {
  const double length = glm::length(travelDirection);
  if (length == 0.0)
    return {};
  const glm::dvec3 from = -travelDirection / length;
  // Straight above or below every azimuth is right; 0 is the calmest.
  const double across = std::hypot(from.x, from.y);
  return {across < 1e-9 ? 0.0 : glm::degrees(std::atan2(from.x, -from.y)),
          glm::degrees(std::asin(std::clamp(from.z, -1.0, 1.0)))};
}

} // namespace limn
