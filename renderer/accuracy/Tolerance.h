// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ImageError.h"
#include "scene/Scene.h"
#include "scene/basics/Image.h"
#include "scene/basics/Message.h"
#include "scene/effects/EffectPlan.h"

#include <functional>
#include <string>

namespace limn {

/// Draws a scene with the settings of its own quality, in so many pixels.
using DrawScene = std::function<Image(const Scene& scene, const glm::ivec2& size)>;

/// By what a renderer can become more accurate.
enum class StepControl {
  local, ///< error-controlled steps, where the projection integrates
  cells, ///< cell by cell: the integral by a fineness, and what does not integrate exactly
  equal  ///< the same step everywhere
};

/// A scene drawn with which keeps a tolerance, as far as pictures of other steps tell.
struct WithinTolerance {
  Scene scene;                 ///< its quality has what was found: the tolerance with its fineness or, where
                               ///< steps are equal, a step without tolerance; and the early termination that
                               ///< the tolerance allows; own weights where the driver's are too coarse
  double estimateLevels = 0.0; ///< of its 99.9th percentile (DEFINITION section 9)
  double meanLevels = 0.0;     ///< of its mean, without what early ends cost
  bool holds = false;
  Message sentence; ///< where it does not hold: what was reached, and what to do; empty otherwise
};

/// Finds the coarsest steps that keep `scene.quality.toleranceLevels`, which must be set, for a picture of
/// `size`. Draws smaller pictures of the same view, whose rays are a sample of its own: of each candidate and
/// of one with half its steps or, cell by cell, one that is all but exact. MIP, MinIP, averages and
/// isosurfaces are exact cell by cell, and draw nothing for it; other renderers get equal steps for them.
/// Where the weights by which the renderer's filter mixes voxels have few bits (SceneFacts), what that adds
/// (errorOfFilter) is counted and steps make up for it; where it is more than half of the tolerance voxels
/// are weighed in floats instead, and for single rays, whose pictures do not tell, always. Throws what `draw`
/// throws.
WithinTolerance withinTolerance(const Scene& scene, const glm::ivec2& size, const DrawScene& draw,
                                StepControl control = StepControl::local, int filterBits = mostFilterBits);

/// What the renderer's filter, whose weights have so many bits, adds to a picture of the scene as it is: a
/// smaller one, whose rays are a sample of its own, is drawn with those and with own weights. Rounding to b
/// bits moves each sample by up to 2^-(b+1) voxel along each axis of the grid, and its gradient with it; what
/// a picture makes of that depends on how steep the function is as much as on the data, so it is measured.
/// All 0, and nothing drawn, for `mostFilterBits` and where voxels are weighed in floats already. Where light
/// travels (DEFINITION section 11) and what comes of it is found along few paths or on a grid: what that
/// adds, from the same picture with light found along many. `isWhole`: the picture in question is of `size`;
/// else that is a sample of it already, of which the percentile is a guess.
ImageError errorOfFilter(const Scene& scene, const glm::ivec2& size, const DrawScene& draw, int filterBits,
                         bool isWhole = true);

/// Whether a scene asks for a tolerance for which nothing has been found yet.
inline bool needsSteps(const Scene& scene) {
  if (isPhysical(scene)) // its error is that of chance
    return false;
  return scene.quality.toleranceLevels && !scene.quality.fineness;
}

/// What was found, in words: "estimated within 0.8 levels, with error-controlled steps of fineness 5".
Message describe(const WithinTolerance& found);

} // namespace limn
