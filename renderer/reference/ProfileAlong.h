// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Gradient.h"
#include "scene/steps/RayProfile.h"
#include "scene/view/Camera.h"

#include <optional>

namespace limn {

/// What a ray meets of a scene, in double precision by the definition itself (DEFINITION section 7): equal
/// steps of the scene's, but at most a quarter of a voxel, without early termination. `scale` maps gradients
/// to r (gradientScale), where the model reads r, and has the smoothed field where normals are smooth.
/// Contributions add up to the alpha of the pixel:
/// - light that is gathered (tissue, tissue over a surface): `T·α` of each piece; the surface takes what is
/// left;
/// - X-ray: of its alpha the share of what is absorbed, for which the order does not matter;
/// - maximum and minimum: all from the first sample of the extreme; average: alike from every sample;
/// - a surface: all from where it is hit.
/// Nothing where the ray misses what is drawn, or there is no volume.
std::optional<RayProfile> profileAlong(const Scene& scene, const GradientScale& scale, const Ray& ray);

} // namespace limn
