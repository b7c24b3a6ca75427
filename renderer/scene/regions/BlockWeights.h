// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/regions/Region.h"

namespace limn {

/// What a region leaves of a block of cells.
enum class BlockWeight : std::uint8_t {
  same,   ///< everywhere as much
  none,   ///< nothing anywhere
  varying ///< here more than there
};

/// Blocks of cells between voxel centres: block i spans the voxels i·cells … (i+1)·cells along each axis, the
/// last one up to the end. One more voxel on each side counts, so that rounding of a position steps over
/// nothing.
struct BlockGrid {
  glm::ivec3 blocks{0};
  glm::ivec3 cells{1};
};

/// For each block, x fastest. Throws Cancelled.
std::vector<BlockWeight> blockWeights(const Region& region, const BlockGrid& grid, const Effort& effort = {});

} // namespace limn
