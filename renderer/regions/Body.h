// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/basics/Effort.h"
#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

#include <cstddef>
#include <string>

namespace limn {

/// The scalar from which on a voxel counts as tissue (DEFINITION section 10): -300 HU where the values are
/// Hounsfield units, elsewhere the threshold that separates object from background best (objectThreshold).
double tissueThreshold(const Volume& volume, const Effort& effort);

/// The valid voxels whose scalar is at least `threshold`.
BitGrid tissueOf(const Volume& volume, double threshold, const Effort& effort);

/// How many faces voxels of `a` share with voxels of `b`, of two sets on one grid without a voxel in common.
std::size_t sharedFaces(const BitGrid& a, const BitGrid& b);

/// The body in a volume, without the table, the holder and what else lies beside it.
struct BodyFinding {
  Region region;        ///< of kind body; of kind all where there is no tissue
  bool isSure = false;  ///< it may be applied without being asked for
  bool isAlone = false; ///< nothing lies beside it that could be hidden
  Message doubt;        ///< why not, to follow a colon: "nothing lies beside it"; empty where it is sure
};

/// Finds the body as DEFINITION section 10 says. What is not sure keeps everything that is connected with it,
/// so that no tissue is cut; nor is a body sure beside which nothing lies, because there is nothing to hide.
/// Works on one bit a voxel. Throws Cancelled.
BodyFinding findBody(const Volume& volume, const Effort& effort = {});

} // namespace limn
