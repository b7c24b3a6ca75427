// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/MemoryBudget.h"
#include "scene/volume/VolumePart.h"

#include <functional>

namespace limn {

/// Which voxels of a volume one of several processes holds, and how it learns what others found of theirs.
struct PartWanted {
  struct Share {
    VoxelBox held; ///< what is read; more where voxels stay on the disk
    VoxelBox own;  ///< within it; of all processes each voxel is one's own
  };
  std::function<Share(const Grid& grid, bool inSlices)> share; ///< see VoxelKeeping::box
  MemoryBudget memory;                                         ///< what does not fit into it lies on the disk

  /// What all processes found of their own voxels, given what this one did; called once. May throw.
  std::function<VoxelFacts(const VoxelFacts& own)> joined;

  /// Handed on to the volume (VolumePart).
  std::function<BinCounts(const Volume&, int mostBins)> binCounts;
  std::function<VisibleVoxels(const Scene&, int unitVoxels)> visible;
};

} // namespace limn
