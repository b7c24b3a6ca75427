// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/basics/Effort.h"

namespace limn {

/// The largest part of a set whose voxels are connected over faces, edges or corners (26 neighbours); the
/// first of several that are equally large. Empty where the set is.
BitGrid largestComponent(const BitGrid& set, const Effort& effort);

/// The seeds, and the voxels of `allowed` that are connected with them over voxels of `allowed` (26
/// neighbours).
BitGrid grownWithin(const BitGrid& seeds, const BitGrid& allowed, const Effort& effort);

/// The set with its holes filled: what is not in it and cannot be left within a slice over the edges of
/// voxels. Slices across z are filled first, then those across y and x of what has come of it.
BitGrid withHolesFilled(const BitGrid& set, const Effort& effort);

} // namespace limn
