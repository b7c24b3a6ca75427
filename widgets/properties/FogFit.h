// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

namespace limn {

/// The distances at which the volume begins and ends before the camera, mm; 0 ≤ near ≤ far.
struct DepthRange {
  double nearMm = 0.0;
  double farMm = 0.0;
};

/// Along the direction of view, of the corners of the box.
DepthRange depthRange(const Camera& camera, const Grid& grid);

/// The scene's fog switched to another mode. Numbers with which nothing would be seen (no density; a linear
/// fog that was never set) are replaced: it begins where the volume does, leaves a fifth of the colour at its
/// far end, and takes the colour of the background.
Fog withFogMode(const Scene& scene, Fog::Mode mode);

} // namespace limn
