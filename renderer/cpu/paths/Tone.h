// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/StableMath.h"
#include "scene/light/Shading.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace limn::cpu {

/// From a display value (sRGB) to linear light, and back, 0..1.
inline double decoded(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}
inline double encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// The display colour of a radiance (DEFINITION section 12): exposed, limited by the knee and encoded.
inline glm::dvec3 displayed(const glm::dvec3& radiance, const Shading& shading) {
  const glm::dvec3 exposed = std::exp2(shading.physical.exposureEv) * glm::max(radiance, glm::dvec3(0.0));
  const glm::dvec3 toned =
      glm::clamp(shading.knee ? knee(exposed, *shading.knee) : exposed, glm::dvec3(0.0), glm::dvec3(1.0));
  return {encoded(toned.r), encoded(toned.g), encoded(toned.b)};
}

} // namespace limn::cpu
