// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/CostModel.h"
#include "scene/Scene.h"

#include <functional>

namespace limn {

/// Draws a picture of the scene, a volume of `edge` voxels along each axis, in 1, 2, 4 … `most` bricks, one
/// brick after the other on `threads` (0: all), and counts what each does. `advance` is called after every
/// division. Throws Error.
std::vector<BrickRow> brickRows(int edge, const Scene& scene, int most, int threads,
                                const std::function<void()>& advance);

} // namespace limn
