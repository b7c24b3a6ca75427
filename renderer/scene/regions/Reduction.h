// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

namespace limn {

/// By how many voxels along each axis a grid is made coarser to be left with about `most` voxels (> 0), as
/// even in all directions as whole numbers allow; 1 along all axes where it has no more.
glm::ivec3 reductionTo(const Grid& grid, std::size_t most);

/// The volume in boxes of so many voxels (≥ 1 along each axis), each their mean; the outermost may hold
/// fewer. Throws Cancelled.
std::shared_ptr<const Volume> reduced(const std::shared_ptr<const Volume>& volume,
                                      const glm::ivec3& reduction, const Effort& effort = {});

/// What is kept of it: of each box the label of its middle voxel.
Region reduced(const Region& region, const glm::ivec3& reduction);

} // namespace limn
