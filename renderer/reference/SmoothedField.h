// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/volume/Volume.h"

namespace limn {

/// The scalars of a volume smoothed at its voxels (DEFINITION section 2), in double precision by the
/// definition itself: along each axis in turn the sum of what a Gaussian weighs. In memory, 16 bytes for each
/// voxel while it is made and 8 then. Throws Cancelled.
Volume smoothedField(const Volume& volume, double sigmaMm, const Effort& effort = {});

} // namespace limn
