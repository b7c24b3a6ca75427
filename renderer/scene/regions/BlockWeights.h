// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/basics/Room.h"
#include "scene/regions/Region.h"

namespace limn {

/// What a region leaves of a block of cells.
enum class BlockWeight : std::uint8_t {
  all,    ///< everything everywhere
  same,   ///< everywhere as much of it
  none,   ///< nothing anywhere
  varying ///< here more than there
};

/// Blocks of cells between voxel centres: block i spans the voxels i·cells … (i+1)·cells along each axis, the
/// volume's last one up to the end. One more voxel on each side counts, so that rounding of a position steps
/// over nothing.
struct BlockGrid {
  glm::ivec3 blocks{0};
  glm::ivec3 cells{1};
  glm::ivec3 first{0}; ///< the block of the first weight
};

/// The voxels of a block along one axis, half open, `last` being the volume's last one there.
struct BlockSpan {
  int begin = 0;
  int end = 0;
};

BlockSpan voxelsOfBlock(int block, int cells, int last);

/// One for each block, x fastest.
using BlockWeights = RoomVector<BlockWeight>;

/// Of each block, in the room given. Throws Cancelled; what Room does.
BlockWeights blockWeights(const Region& region, const BlockGrid& grid, const Effort& effort = {},
                          const std::shared_ptr<Room>& room = {});

} // namespace limn
