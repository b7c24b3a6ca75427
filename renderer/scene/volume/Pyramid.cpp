// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Pyramid.h"

#include "scene/volume/CoarseField.h"

#include <algorithm>

namespace limn {
namespace {

constexpr int usualReductions[] = {2, 4, 8};

// Slabs of so many voxels: what is averaged is still at hand when it is compared.
constexpr std::int64_t slabVoxels = std::int64_t{1} << 21;

glm::ivec3 reducedDims(const glm::ivec3& dims, int reduction) {
  return (dims + reduction - 1) / reduction;
}

std::uint64_t voxelsOf(const glm::ivec3& dims) {
  return static_cast<std::uint64_t>(dims.x) * static_cast<std::uint64_t>(dims.y) *
         static_cast<std::uint64_t>(dims.z);
}

std::vector<int> reductionsWithin(const glm::ivec3& dims, std::uint64_t mostVoxels) {
  std::vector<int> reductions;
  for (const int reduction : usualReductions)
    if (voxelsOf(reducedDims(dims, reduction)) <= mostVoxels)
      reductions.push_back(reduction);
  int reduction = usualReductions[std::size(usualReductions) - 1];
  while (reductions.empty()) {
    reduction *= 2;
    const glm::ivec3 coarse = reducedDims(dims, reduction);
    if (voxelsOf(coarse) <= mostVoxels || coarse == glm::ivec3(1))
      reductions.push_back(reduction);
  }
  return reductions;
}

// Of the numbers as they are stored.
ValueRange storedRange(const Volume& volume) {
  if (volume.rescale().slope == 0.0)
    return {};
  const auto stored = [&rescale = volume.rescale()](double scalar) {
    return (scalar - rescale.intercept) / rescale.slope;
  };
  const double a = stored(volume.range().lowest), b = stored(volume.range().highest);
  return {std::min(a, b), std::max(a, b)};
}

template <class T>
std::vector<CoarseVolume> pyramidAs(const Volume& volume, const StoredVoxels<T>& stored,
                                    const std::vector<int>& reductions, const Effort& effort) {
  const glm::ivec3 dims = volume.grid().dims;
  std::vector<CoarseField<T>> fields;
  fields.reserve(reductions.size());
  for (const int reduction : reductions)
    fields.emplace_back(stored, storedRange(volume), dims, reducedDims(dims, reduction));
  const auto slices =
      static_cast<int>(std::clamp<std::int64_t>(slabVoxels / (std::int64_t{dims.x} * dims.y), 1, dims.z));
  for (int end = 0; end < dims.z;) {
    const double from = static_cast<double>(end) / dims.z;
    end = std::min(end + slices, dims.z);
    const double share = (static_cast<double>(end) / dims.z - from) / static_cast<double>(fields.size());
    for (std::size_t n = 0; n < fields.size(); ++n)
      fields[n].takeSlices(end, partOf(effort, from + share * static_cast<double>(n),
                                       from + share * static_cast<double>(n + 1)));
  }
  const ValueRange& range = volume.range();
  const double perValue = range.highest > range.lowest ? 1.0 / (range.highest - range.lowest) : 0.0;
  std::vector<CoarseVolume> levels;
  for (std::size_t n = 0; n < fields.size(); ++n) {
    const double error = fields[n].largestDifference() * std::abs(volume.rescale().slope) * perValue;
    levels.push_back(
        {std::make_shared<const Volume>(withVoxels(volume.grid(), fields[n].dims()), fields[n].takeVoxels(),
                                        volume.rescale(), std::nullopt, volume.info(),
                                        Effort{effort.threads, effort.isCancelled, {}}),
         reductions[n], error});
  }
  return levels;
}

} // namespace

Grid withVoxels(const Grid& grid, const glm::ivec3& dims) {
  const glm::dvec3 each = glm::dvec3(grid.dims) / glm::dvec3(dims);
  Grid other = grid;
  other.dims = dims;
  other.spacingMm = grid.spacingMm * each;
  other.originMm = indexToWorld(grid, 0.5 * (each - 1.0));
  return other;
}

std::vector<CoarseVolume> pyramidOf(const Volume& volume, std::uint64_t mostBytes, const Effort& effort) {
  return visitVoxels(volume, [&]<class T>(const StoredVoxels<T>& stored) {
    return pyramidAs(volume, stored, reductionsWithin(volume.grid().dims, mostBytes / sizeof(T)), effort);
  });
}

} // namespace limn
