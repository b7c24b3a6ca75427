// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"

#include <cstddef>

namespace limn {

/// How many faces voxels of `a` share with voxels of `b`, of two sets on one grid without a voxel in common.
std::size_t sharedFaces(const BitGrid& a, const BitGrid& b);

} // namespace limn
