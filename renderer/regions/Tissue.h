// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/volume/Volume.h"

namespace limn {

/// The scalar from which on a voxel counts as tissue (DEFINITION section 10): -300 HU where the values are
/// Hounsfield units, elsewhere the threshold that separates object from background best (objectThreshold).
double tissueThreshold(const Volume& volume, const Effort& effort);

/// The valid voxels whose scalar is at least `threshold`.
BitGrid tissueOf(const Volume& volume, double threshold, const Effort& effort);

} // namespace limn
