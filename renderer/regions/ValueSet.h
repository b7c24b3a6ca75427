// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/basics/Effort.h"
#include "scene/volume/Volume.h"

namespace limn {

/// The valid voxels whose scalar lies from `range.x` to `range.y`, both included; either may be infinite.
/// Throws Cancelled.
BitGrid valuesWithin(const Volume& volume, const glm::dvec2& range, const Effort& effort);

} // namespace limn
