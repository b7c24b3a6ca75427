// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <optional>
#include <vector>

namespace limn {

/// What one ray of a picture meets, and what each part of it gives to its pixel.
struct RayProfile {
  /// A piece of the ray, told by its middle; a surface is a piece without length.
  struct Sample {
    double depthMm = 0.0;  ///< from where the ray enters what is drawn, ≥ 0
    double lengthMm = 0.0; ///< ≥ 0
    double value = 0.0;    ///< scalar units
    double opacityPerMm =
        0.0; ///< 0..1, of a millimetre of it; where one value is classified once: of that value
    double contribution = 0.0; ///< its share of the pixel, 0..1
    glm::dvec3 color{0.0};     ///< of the transfer function, 0..1
  };

  Projection projection = Projection::composite;
  glm::dvec3 entryMm{0.0};             ///< world, where the ray enters what is drawn
  glm::dvec3 direction{0.0, 1.0, 0.0}; ///< world, unit length
  double lengthMm = 0.0;               ///< > 0, until it leaves again
  double alpha = 0.0;                  ///< 0..1, of the pixel: the sum of the contributions
  std::vector<Sample> samples;         ///< front to back
};

/// The place at a depth, world millimetres.
glm::dvec3 placeAt(const RayProfile& profile, double depthMm);

/// The sample whose piece holds a depth, or the nearest one; there are samples.
const RayProfile::Sample& sampleAt(const RayProfile& profile, double depthMm);

/// The depth at which half of what the ray gives is gathered, mm: half of the light, of a projection of
/// extremes the extreme value, of a surface its place. Within a piece light grows evenly. Nothing where the
/// ray gives less than half an 8-bit level, and of an average, to which every depth gives alike.
std::optional<double> halfLightDepth(const RayProfile& profile);

/// The depth of the piece that gives most to the pixel, mm, the nearest of equal ones: of a dense thing
/// behind a veil the dense thing, however much the veil gathers on its way. Nothing where halfLightDepth
/// gives nothing.
std::optional<double> strongestDepth(const RayProfile& profile);

/// Whether what opacity a sample has depends on its length: of light that is gathered along the way.
bool gathersLight(Projection projection);

} // namespace limn
