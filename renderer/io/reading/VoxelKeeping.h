// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/MemoryBudget.h"
#include "scene/volume/Grid.h"

#include <functional>

namespace limn {

/// Which voxels of a volume a reader keeps, and in how much memory. Readers that are not told of a box keep
/// all.
struct VoxelKeeping {
  VoxelKeeping(const MemoryBudget& memory) : budget(memory) {} // a budget alone keeps all

  MemoryBudget budget;

  /// The voxels to keep of a volume on `grid`, `inSlices` where it is read slice by slice; absent: all. A
  /// reader asks once, before it reads the first of them. It may give more nevertheless, and says which
  /// (VolumeParts::held).
  std::function<VoxelBox(const Grid& grid, bool inSlices)> box;
};

} // namespace limn
