// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/BenchRow.h"

namespace limn {

/// What opening and drawing a volume of one size cost.
struct ScaleRow {
  int edge = 0;        ///< voxels along each axis
  double voxelsMb = 0; ///< 10⁶ bytes, as they are stored
  FrameCost opened;    ///< from the file to the volume, the same for all renderers of a size
  double openedMb = 0; ///< the most memory that it took
  BenchRow drawn;      ///< by one renderer
};

} // namespace limn
