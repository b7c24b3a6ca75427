// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Room.h"
#include "scene/volume/Volume.h"

#include <vector>

namespace limn {

/// Cells between voxel centres along each edge of a block of facts.
inline constexpr int factCells = 4;

/// What is known of the field in one block, whatever the transfer function.
struct FieldFacts {
  ValueRange range;           ///< of the voxels on and in it
  double steepestPerMm = 0.0; ///< a bound of the change along any direction, value/mm
  double bendPerMm2 = 0.0;    ///< the largest change of the slope from voxel to voxel, value/mm²
  bool operator==(const FieldFacts&) const = default;
};

/// The field in blocks of 4³ cells between voxel centres; neighbours share the voxels on their common face.
/// The outermost blocks also own the half voxel before the volume's end, where the field is constant.
struct BlockFacts {
  glm::ivec3 blocks{0};
  RoomVector<FieldFacts> facts; ///< x fastest, in the volume's room
  ValueRange range;             ///< of all
  double commonPerMm = 0.0;     ///< what the field commonly changes by at most, value/mm (steepness)
};

/// One pass over the volume: keep the result while the volume stays. Throws Cancelled.
BlockFacts blockFacts(const Volume& volume, const Effort& effort = {});

} // namespace limn
