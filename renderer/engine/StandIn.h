// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

namespace limn {

/// How a volume in fewer voxels stands for the whole one.
struct Coarseness {
  int reduction = 1;         ///< so many voxels of the whole one along each axis make one
  double largestError = 0.0; ///< values differ nowhere by more than this share of the whole one's range
  bool operator==(const Coarseness&) const = default;
};

/// A scene that is drawn in place of another while something moves.
struct StandIn {
  Scene scene; ///< the same but for the volume, what is kept of it, and that steps are in its own voxels
  Coarseness coarseness;
};

} // namespace limn
