// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

namespace limn {

/// What a format reader found, before the reader's options are applied and the volume is made. Readers set
/// `info.spacingKnown` and `info.orientationKnown`; the sentences about them are added in one place.
struct VolumeParts {
  Grid grid;
  VoxelArray stored;
  Rescale rescale;
  VolumeInfo info;
  std::shared_ptr<Room> room; ///< where `stored` lies; null: in memory
};

} // namespace limn
