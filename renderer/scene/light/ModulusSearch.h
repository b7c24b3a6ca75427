// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/volume/Volume.h"

#include <optional>

namespace limn {

/// What the gradient moduli of a volume's eligible voxels hold, value/mm; 0 where none is eligible.
struct FoundModuli {
  double largest = 0.0;
  double percentile = 0.0; ///< a float, or the largest itself
};

/// Finds the largest modulus and, where a `percent` (0..100] is given, that nearest-rank percentile: the
/// exact element, rounded to float; at 100 the largest itself. As a rule in one pass over the volume, the
/// same for any number of threads: a quick estimate in float tells which moduli could be either, and only
/// those are computed in double.
FoundModuli findModuli(const Volume& volume, std::optional<double> percent, const Effort& effort = {});

} // namespace limn
