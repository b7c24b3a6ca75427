// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace limn {

/// No limit on what a volume may take on the graphics card but the driver's own.
inline constexpr double anyMb = std::numeric_limits<double>::infinity();

/// What a volume may take on the graphics card, and what becomes of one that does not fit.
struct VolumeRoom {
  double mostMb = anyMb; ///< 10⁶ bytes, > 0
  bool mayReduce = true; ///< show it with fewer voxels; false: throw VolumeTooLarge (engine/VolumeTooLarge.h)
};

} // namespace limn
