// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace limn {

/// A volume in fewer voxels that fill the same box: each the mean of those that it stands for.
struct CoarseVolume {
  std::shared_ptr<const Volume> volume; ///< in memory, in the type of the whole one
  int reduction = 1;                    ///< so many voxels of the whole one along each axis make one
  double largestError = 0.0; ///< a bound, tight to rounding: nowhere in the box do both fields differ by more
                             ///< than this share of the whole one's range
};

/// The volume at reductions of 2, 4 and 8, the finest first; those of which the voxels take more than
/// `mostBytes` are left out, and where all do there is one, of the first power of two that takes no more. One
/// pass over the voxels, a slab after the other. Throws Cancelled.
std::vector<CoarseVolume> pyramidOf(const Volume& volume, std::uint64_t mostBytes, const Effort& effort = {});

/// The grid of so many voxels in the same box.
Grid withVoxels(const Grid& grid, const glm::ivec3& dims);

} // namespace limn
