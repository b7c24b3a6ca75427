// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Volume.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Counts of the valid voxels over equal bins from the lowest to the highest scalar.
struct Histogram {
  ValueRange range;
  std::vector<std::uint64_t> counts;
  bool operator==(const Histogram&) const = default;
};

/// Counts every valid voxel of `volume` once; a constant volume fills the first bin. `bins` > 0.
Histogram histogramOf(const Volume& volume, int bins = 1024);

} // namespace limn
