// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

namespace limn {

/// Cubes of `edge` voxels whose labels take turns, one weight (0..1) for each label: neighbours differ.
Region cubesRegion(const glm::ivec3& dims, int edge, const std::vector<double>& weights);

} // namespace limn
