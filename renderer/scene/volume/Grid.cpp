// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Grid.h"

#include <algorithm>

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

glm::dvec3 indexToWorld(const Grid& grid, const glm::dvec3& index) {
  return grid.originMm + grid.direction * (grid.spacingMm * index);
}

glm::dvec3 worldToIndex(const Grid& grid, const glm::dvec3& worldMm) {
  return worldVectorToIndex(grid, worldMm - grid.originMm);
}

glm::dvec3 worldVectorToIndex(const Grid& grid, const glm::dvec3& vectorMm) {
  // The direction is orthonormal, so its inverse is its transpose.
  return glm::transpose(grid.direction) * vectorMm / grid.spacingMm;
}

glm::dvec3 boxSizeMm(const Grid& grid) {
  return glm::dvec3(grid.dims) * grid.spacingMm;
}

glm::dvec3 boxCentreMm(const Grid& grid) {
  return indexToWorld(grid, (glm::dvec3(grid.dims) - 1.0) / 2.0);
}

double boxDiagonalMm(const Grid& grid) {
  return glm::length(boxSizeMm(grid));
}

double smallestSpacingMm(const Grid& grid) {
  return std::min({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z});
}

std::optional<int> imageNormalAxis(const Grid& grid) {
  std::optional<int> axis;
  for (int i = 0; i < 3; ++i)
    if (grid.dims[i] == 1) {
      if (axis)
        return std::nullopt;
      axis = i;
    }
  return axis;
}

} // namespace limn
