// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/paths/PathRandom.h"
#include "scene/light/LightDirections.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn::cpu {

/// The unit vector at an angle from an axis, given by its cosine, turned about it by chance.
inline glm::vec3 turnedFrom(const glm::vec3& axis, float cosine, PathRandom& random) {
  const float sine = std::sqrt(std::max(1.0f - cosine * cosine, 0.0f));
  const float angle = 2.0f * std::numbers::pi_v<float> * random.next();
  return glm::normalize(axesAround(axis) * glm::vec3(sine * std::cos(angle), sine * std::sin(angle), cosine));
}

/// A direction within a cone, evenly over its solid angle.
inline glm::vec3 withinCone(const glm::vec3& axis, float leastCosine, PathRandom& random) {
  if (leastCosine >= 1.0f)
    return axis;
  return turnedFrom(axis, 1.0f - random.next() * (1.0f - leastCosine), random);
}

/// Henyey and Greenstein's phase function: per solid angle, by the cosine between the ways before and after.
inline float phase(float g, float cosine) {
  const float d = std::max(1.0f + g * g - 2.0f * g * cosine, 1e-12f);
  return (1.0f - g * g) / (4.0f * std::numbers::pi_v<float> * d * std::sqrt(d));
}

/// Draws the way after from it.
inline glm::vec3 phaseDirection(float g, const glm::vec3& before, PathRandom& random) {
  const float u = random.next();
  float cosine = 1.0f - 2.0f * u;
  if (std::abs(g) > 1e-3f) {
    const float q = (1.0f - g * g) / (1.0f + g - 2.0f * g * u);
    cosine = std::clamp((1.0f + g * g - q * q) / (2.0f * g), -1.0f, 1.0f);
  }
  return turnedFrom(before, cosine, random);
}

/// What a surface sends on (DEFINITION section 12): Lambert's law, and with the share `specular` that of Cook
/// and Torrance with Blinn's distribution. All directions point away from it; `normal` to the viewer's side.
struct Surface {
  glm::vec3 normal{0.0f};
  glm::vec3 albedo{1.0f};
  float specular = 0.0f; ///< k
  float exponent = 1.0f; ///< SP

  /// BRDF times the cosine of the light.
  glm::vec3 reflected(const glm::vec3& view, const glm::vec3& light) const {
    const float nl = glm::dot(normal, light);
    const float nv = std::max(glm::dot(normal, view), leastCosine);
    if (!(nl > 0.0f))
      return glm::vec3(0.0f);
    const glm::vec3 lambert = (1.0f - specular) * albedo * (nl / std::numbers::pi_v<float>);
    const glm::vec3 sum = light + view;
    const float size = glm::length(sum);
    if (!(specular > 0.0f) || !(size > leastCosine))
      return lambert;
    const glm::vec3 half = sum / size;
    const float nh = std::clamp(glm::dot(normal, half), 0.0f, 1.0f);
    const float vh = std::max(glm::dot(view, half), leastCosine);
    const float d = (exponent + 2.0f) / (2.0f * std::numbers::pi_v<float>)*std::pow(nh, exponent);
    return lambert + specular * d * masking(nh, nv, nl, vh) / (4.0f * nv);
  }

  /// Draws the direction from which light comes; what that is worth: BRDF times cosine over the chance of
  /// having drawn it. Black where none comes.
  glm::vec3 drawn(const glm::vec3& view, PathRandom& random, glm::vec3& light) const {
    if (!(random.next() < specular)) {
      light = turnedFrom(normal, std::sqrt(1.0f - random.next()), random);
      return glm::dot(normal, light) > 0.0f ? albedo : glm::vec3(0.0f);
    }
    const float nh = std::pow(1.0f - random.next(), 1.0f / (exponent + 2.0f));
    const glm::vec3 half = turnedFrom(normal, std::min(nh, 1.0f), random);
    const float vh = glm::dot(view, half);
    light = glm::normalize(2.0f * vh * half - view);
    const float nl = glm::dot(normal, light);
    const float nv = std::max(glm::dot(normal, view), leastCosine);
    if (!(vh > leastCosine) || !(nl > 0.0f))
      return glm::vec3(0.0f);
    const float cosine = std::max(glm::dot(normal, half), leastCosine);
    return glm::vec3(masking(cosine, nv, nl, vh) * vh / (nv * cosine));
  }

private:
  static constexpr float leastCosine = 1e-6f;

  static float masking(float nh, float nv, float nl, float vh) {
    return std::min({1.0f, 2.0f * nh * nv / vh, 2.0f * nh * nl / vh});
  }
};

} // namespace limn::cpu
