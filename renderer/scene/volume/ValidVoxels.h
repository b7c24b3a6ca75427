// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/volume/Volume.h"

namespace limn {

/// What sanitising found.
struct ValidVoxels {
  double smallest = 0.0; ///< stored values of the valid voxels
  double largest = 0.0;
  std::size_t invalidVoxels = 0;
  VoxelMask invalid;   ///< empty where all are valid
  StoredCounts counts; ///< of the valid
};

/// Finds the valid voxels, and replaces NaN, ±Inf and padding by the smallest valid stored value, or by the
/// largest where the rescale falls. One pass; a second where voxels are invalid. Throws Error (input) where
/// no voxel is valid; Cancelled. Where voxels cannot be changed in their place, the copy lies in `room`, and
/// so does the mask.
ValidVoxels sanitise(VoxelArray& stored, const Rescale& rescale, const std::optional<PaddingRange>& padding,
                     const Effort& effort, const std::shared_ptr<Room>& room = {});

} // namespace limn
