// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace limn {

/// Where a fixed light stands, seen from the patient.
struct LightAngles {
  double azimuthDeg = 0.0;   ///< -180..180: 0 in front (anterior), 90 at the patient's left
  double elevationDeg = 0.0; ///< -90..90: 90 above the head
};

/// The direction in which the light travels, unit length, patient space (LPS).
glm::dvec3 travelDirection(const LightAngles& angles);

/// The angles of a direction of travel; the front for the zero vector.
LightAngles lightAngles(const glm::dvec3& travelDirection);

} // namespace limn
