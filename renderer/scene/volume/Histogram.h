// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace limn {

/// Counts of the valid voxels over equal bins that fill `range`.
struct Histogram {
  ValueRange range;
  std::vector<std::uint64_t> counts;
  bool operator==(const Histogram&) const = default;
};

/// Counts every valid voxel of `volume` once, in at most `mostBins` > 0 bins from the lowest to the highest
/// scalar. Bins of integer data are centred on values and hold equally many of them each, so that no comb
/// appears; a constant volume has one bin. Costs a pass over voxels of more than 16 bits, of others none; of
/// a volume in parts (VolumePart.h) each process counts its own.
Histogram histogramOf(const Volume& volume, int mostBins = 1024, const Effort& effort = {});

/// The bins of histogramOf, empty.
Histogram binsOf(const Volume& volume, int mostBins = 1024);

/// Where values are counted.
class HistogramBins {
public:
  explicit HistogramBins(const Histogram& histogram)
      : m_lowest(histogram.range.lowest), m_last(static_cast<int>(histogram.counts.size()) - 1) {
    const double width = histogram.range.highest - histogram.range.lowest;
    m_binsPerValue = width > 0.0 ? (m_last + 1) / width : 0.0;
  }

  /// The bin of a value; the first or the last for one beyond the range.
  std::size_t of(double value) const {
    return static_cast<std::size_t>(
        std::clamp(static_cast<int>((value - m_lowest) * m_binsPerValue), 0, m_last));
  }

private:
  double m_lowest;
  double m_binsPerValue;
  int m_last;
};

/// In the unit of the values. There is at least one bin.
double binWidth(const Histogram& histogram);

/// The value in the middle of a bin.
double valueOfBin(const Histogram& histogram, std::size_t bin);

/// The value below which `fraction` (0..1) of the counted voxels lie, to within one bin.
double quantile(const Histogram& histogram, double fraction);

} // namespace limn
