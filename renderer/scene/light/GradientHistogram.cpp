// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/GradientHistogram.h"

#include "scene/light/Gradient.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <mutex>

namespace limn {
namespace {

// Counts the eligible moduli, in units of `modulusUnit`, of a row of voxels.
template <class T>
void countRow(const Stencil<T>& stencil, const EligibleVoxels& eligible, int j, int k, double binsPerModulus,
              std::vector<std::uint64_t>& counts) {
  for (int i = 0; i < stencil.dims.x; ++i)
    if (eligible.has(i, j, k))
      ++counts[std::min(static_cast<std::size_t>(stencil.modulus(i, j, k) * binsPerModulus),
                        counts.size() - 1)];
}

} // namespace

Histogram gradientHistogram(const Volume& volume, int bins, const Effort& effort) {
  assert(bins > 0);
  const double largest = largestGradient(volume, effort);
  const double binsPerModulus = bins / (largest / modulusUnit(volume));
  const bool isFlat = !std::isfinite(binsPerModulus);
  Histogram histogram{{0.0, largest},
                      std::vector<std::uint64_t>(isFlat ? 1 : static_cast<std::size_t>(bins), 0)};
  const EligibleVoxels eligible(volume);
  const RowPieces rows(volume.grid().dims);
  std::mutex mutex;
  visitVoxels(volume, [&]<class T>(const StoredVoxels<T>& stored) {
    const Stencil<T> stencil{volume, stored};
    shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
      std::vector<std::uint64_t> own(histogram.counts.size(), 0);
      for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
        rows.forEachRow(piece, [&](int j, int k) {
          countRow(stencil, eligible, j, k, isFlat ? 0.0 : binsPerModulus, own);
        });
      const std::lock_guard lock(mutex);
      for (std::size_t bin = 0; bin < own.size(); ++bin)
        histogram.counts[bin] += own[bin];
    });
  });
  return histogram;
}

GradientOpacity boundaryRamp(const Histogram& gradients) {
  if (!(gradients.range.highest > 0.0))
    return {{{0.0, 1.0}}};
  const double fades = quantile(gradients, 0.60);
  const double stays = quantile(gradients, 0.97);
  if (!(stays > fades)) // nearly all voxels have no gradient, as in a volume of labels
    return {{{0.0, 0.0}, {gradients.range.highest / 2.0, 1.0}}};
  return {{{fades, 0.0}, {stays, 1.0}}};
}

} // namespace limn
