// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Gradient.h"
#include "scene/light/LightingTerms.h"
#include "scene/steps/RayFrame.h"

namespace limn {

/// What lighting needs of a ray, the same for all its samples; unit vectors along the grid's axes.
struct RayLight {
  glm::dvec3 toViewer{0.0};
  glm::dvec3 toLight{0.0};
  glm::dvec3 halfway{0.0};
};

/// The light along a ray of unit direction (grid axes). `towardsLight` absent: headlight.
RayLight lightAlong(const glm::dvec3& direction, const std::optional<glm::dvec3>& towardsLight);

/// What share of its light comes to a sample (DEFINITION section 11).
struct Reaching {
  double direct = 1.0;  ///< S, of what is reflected
  double ambient = 1.0; ///< A
};

/// The colour of a lit sample (DEFINITION sections 4 and 5); the material itself where the terms are unlit.
glm::dvec3 lit(const LightingTerms& terms, const glm::dvec3& material, const RayLight& light,
               const glm::dvec3& normal, double ratio, const Reaching& reaching = {});

/// The factor on the colour of an object at `z` mm from the eye (DEFINITION section 6).
double fogFactor(const Fog& fog, double z);

} // namespace limn
