// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/framing/KeptVoxels.h"

#include "scene/steps/RayFrame.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <functional>
#include <mutex>

namespace limn {

VoxelBox croppedVoxels(const Grid& grid, const CropBox& crop) {
  const IndexBox box = croppedBox(grid, crop);
  const glm::dvec3 centre = centreIndex(grid);
  return {glm::max(glm::ivec3(glm::ceil(box.lower + centre)), 0),
          glm::min(glm::ivec3(glm::floor(box.upper + centre)) + 1, grid.dims)};
}

KeptVoxels::KeptVoxels(const Grid& grid, const Region& keep, const CropBox& crop)
    : m_dims(grid.dims), m_box(croppedVoxels(grid, crop)) {
  const bool isRestricted = isRestricting(keep);
  if (isRestricted) {
    m_labels = keep.labels;
    for (const double weight : keep.weights)
      m_isKept.push_back(weight > 0.0 ? 1 : 0);
  }
  m_areAll = !isRestricted && m_box.lower == glm::ivec3(0) && m_box.upper == m_dims;
}

Histogram histogramOfKept(const Volume& volume, const KeptVoxels& kept, int mostBins, const Effort& effort) {
  if (kept.areAll())
    return histogramOf(volume, mostBins, effort);
  Histogram histogram = binsOf(volume, mostBins);
  const HistogramBins bins(histogram);
  const Rescale rescale = volume.rescale();
  const glm::ivec3 dims = volume.grid().dims;
  const VoxelMask& invalid = volume.invalidMask();
  const RowPieces rows(dims);
  std::mutex mutex;
  visitVoxels(volume, [&](const auto& stored) {
    shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
      std::vector<std::uint64_t> own(histogram.counts.size(), 0);
      const auto count = [&](int j, int k) {
        for (int i = 0; i < dims.x; ++i) {
          const std::size_t voxel = voxelOffset(dims, i, j, k);
          if (kept.has(i, j, k) && (invalid.empty() || !invalid[voxel]))
            ++own[bins.of(rescale.slope * static_cast<double>(stored[voxel]) + rescale.intercept)];
        }
      };
      for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
        rows.forEachRow(piece, count);
      const std::lock_guard lock(mutex);
      std::transform(own.begin(), own.end(), histogram.counts.begin(), histogram.counts.begin(),
                     std::plus<>());
    });
  });
  return histogram;
}

Histogram heldWithin(Histogram histogram, double lowest, double highest) {
  const double half = binWidth(histogram) / 2.0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const double value = valueOfBin(histogram, bin);
    if (value + half < lowest || value - half > highest)
      histogram.counts[bin] = 0;
  }
  return histogram;
}

Histogram shownBy(const TransferFunction& function, Histogram histogram) {
  const double half = binWidth(histogram) / 2.0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const double value = valueOfBin(histogram, bin);
    if (!(largestOpacityWithin(function, value - half, value + half) > 0.0))
      histogram.counts[bin] = 0;
  }
  return histogram;
}

} // namespace limn
