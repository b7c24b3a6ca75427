// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Grid.h"

namespace limn {

/// Voxels from `lower` on, up to those before `upper`; empty where an axis has none.
struct VoxelBox {
  glm::ivec3 lower{0};
  glm::ivec3 upper{0};
};

/// The box with a voxel more on each side, as far as the grid has any.
VoxelBox widened(const VoxelBox& box, const Grid& grid);

/// The grid of a box of voxels alone, which is not empty: the same places in the world.
Grid partOf(const Grid& grid, const VoxelBox& box);

} // namespace limn
