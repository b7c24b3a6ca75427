// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/PlaneGrid.h"
#include "scene/Scene.h"

#include <vector>

namespace limn {

/// Where a plane cuts the crop box: the corners of that polygon in their order around it, world millimetres.
/// None where the crop cuts nothing of the volume or the plane misses the box.
std::vector<glm::dvec3> cropOutline(const Grid& volume, const CropBox& crop, const PlaneGrid& plane);

} // namespace limn
