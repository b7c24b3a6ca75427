// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Histogram.h"

#include "scene/volume/VolumePart.h"

#include <cassert>
#include <cmath>
#include <functional>
#include <mutex>
#include <numeric>
#include <type_traits>

namespace limn {

namespace {

// The scalar distance between neighbouring stored values, 0 for floating-point data.
double quantumOf(const Volume& volume) {
  const auto quantum = [&]<class T>(const StoredVoxels<T>&) {
    return std::is_integral_v<T> ? std::abs(volume.rescale().slope) : 0.0;
  };
  return std::visit(quantum, volume.stored());
}

} // namespace

Histogram binsOf(const Volume& volume, int mostBins) {
  assert(mostBins > 0);
  const ValueRange range = volume.range();
  const double width = range.highest - range.lowest;
  const double quantum = quantumOf(volume);
  if (!(width > 0.0))
    return {range, std::vector<std::uint64_t>(1, 0)};
  if (!(quantum > 0.0))
    return {range, std::vector<std::uint64_t>(static_cast<std::size_t>(mostBins), 0)};
  const double values = std::round(width / quantum) + 1.0;
  const double valuesPerBin = std::ceil(values / mostBins);
  const double bins = std::ceil(values / valuesPerBin);
  const double first = range.lowest - quantum / 2.0;
  return {{first, first + bins * valuesPerBin * quantum},
          std::vector<std::uint64_t>(static_cast<std::size_t>(bins), 0)};
}

Histogram histogramOf(const Volume& volume, int mostBins, const Effort& effort) {
  Histogram histogram = binsOf(volume, mostBins);
  const HistogramBins bins(histogram);
  const Rescale rescale = volume.rescale();
  const auto binOf = [&](auto stored) {
    return bins.of(rescale.slope * static_cast<double>(stored) + rescale.intercept);
  };
  const StoredCounts& known = volume.storedCounts();
  for (std::size_t i = 0; i < known.counts.size(); ++i)
    histogram.counts[binOf(known.first + static_cast<int>(i))] += known.counts[i];
  if (!known.counts.empty())
    return histogram;
  if (volume.part()) {
    histogram.counts = volume.part()->binCounts(volume, mostBins).counts;
    return histogram;
  }
  const VoxelMask& invalid = volume.invalidMask();
  std::mutex mutex;
  visitVoxels(volume, [&](const auto& stored) {
    const std::size_t pieceCount = (stored.size() + voxelsPerPiece - 1) / voxelsPerPiece;
    shareOut(static_cast<int>(pieceCount), effort, [&](Pieces& pieces) {
      std::vector<std::uint64_t> own(histogram.counts.size(), 0);
      for (int piece = pieces.next(); piece >= 0; piece = pieces.next()) {
        const std::size_t first = static_cast<std::size_t>(piece) * voxelsPerPiece;
        for (std::size_t i = first; i < std::min(first + voxelsPerPiece, stored.size()); ++i)
          if (invalid.empty() || !invalid[i])
            ++own[binOf(stored[i])];
      }
      const std::lock_guard lock(mutex);
      std::transform(own.begin(), own.end(), histogram.counts.begin(), histogram.counts.begin(),
                     std::plus<>());
    });
  });
  return histogram;
}

double binWidth(const Histogram& histogram) {
  return (histogram.range.highest - histogram.range.lowest) / static_cast<double>(histogram.counts.size());
}

double valueOfBin(const Histogram& histogram, std::size_t bin) {
  return histogram.range.lowest + (static_cast<double>(bin) + 0.5) * binWidth(histogram);
}

double quantile(const Histogram& histogram, double fraction) {
  const auto total = static_cast<double>(
      std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0}));
  double counted = 0.0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    counted += static_cast<double>(histogram.counts[bin]);
    if (counted >= fraction * total)
      return valueOfBin(histogram, bin);
  }
  return histogram.range.highest;
}

} // namespace limn
