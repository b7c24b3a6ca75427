// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace limn {

/// Where the voxels of a volume lie: `world = origin + direction · diag(spacing) · index`, world in the
/// patient space LPS, millimetres. A voxel owns its full extent, so the volume fills [-0.5, n-0.5) on each
/// index axis (DEFINITION section 1).
struct Grid {
  glm::ivec3 dims{0};
  glm::dvec3 spacingMm{1.0}; ///< each > 0
  glm::dvec3 originMm{0.0};  ///< centre of voxel (0,0,0)
  glm::dmat3 direction{1.0}; ///< orthonormal, columns are the grid axes; may be left-handed

  bool operator==(const Grid&) const = default;
};

/// Maps a continuous voxel index to world millimetres.
glm::dvec3 indexToWorld(const Grid& grid, const glm::dvec3& index);

/// Maps world millimetres to a continuous voxel index.
glm::dvec3 worldToIndex(const Grid& grid, const glm::dvec3& worldMm);

/// Maps a world vector (a direction, mm) to index units per millimetre.
glm::dvec3 worldVectorToIndex(const Grid& grid, const glm::dvec3& vectorMm);

/// Edge lengths of the volume box, mm: `dims · spacing`.
glm::dvec3 boxSizeMm(const Grid& grid);

/// Centre of the volume box in world millimetres.
glm::dvec3 boxCentreMm(const Grid& grid);

/// Length of the diagonal of the volume box, mm.
double boxDiagonalMm(const Grid& grid);

/// The smallest spacing, mm: the unit in which a sampling step is given.
double smallestSpacingMm(const Grid& grid);

/// The index axis along which there is one sample, where the other two have more: the grid of an image.
std::optional<int> imageNormalAxis(const Grid& grid);

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
