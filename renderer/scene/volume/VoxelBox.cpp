// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/VoxelBox.h"

namespace limn {

VoxelBox widened(const VoxelBox& box, const Grid& grid) {
  return {glm::max(box.lower - 1, glm::ivec3(0)), glm::min(box.upper + 1, grid.dims)};
}

Grid partOf(const Grid& grid, const VoxelBox& box) {
  Grid part = grid;
  part.dims = box.upper - box.lower;
  part.originMm = indexToWorld(grid, glm::dvec3(box.lower));
  return part;
}

} // namespace limn
