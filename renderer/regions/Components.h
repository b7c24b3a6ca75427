// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/basics/Effort.h"

namespace limn {

/// The largest part of a set whose voxels are connected over faces, edges or corners (26 neighbours); the
/// first of several that are equally large. Empty where the set is.
BitGrid largestComponent(const BitGrid& set, const Effort& effort);

} // namespace limn
