// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/Reduction.h"

#include <algorithm>

namespace limn {
namespace {

glm::ivec3 reducedDims(const glm::ivec3& dims, const glm::ivec3& reduction) {
  return (dims + reduction - 1) / reduction;
}

std::size_t countOf(const glm::ivec3& dims) {
  return static_cast<std::size_t>(dims.x) * dims.y * dims.z;
}

// The middle of the first box becomes the origin.
Grid reducedGrid(const Grid& grid, const glm::ivec3& reduction) {
  Grid coarse = grid;
  coarse.dims = reducedDims(grid.dims, reduction);
  coarse.spacingMm = grid.spacingMm * glm::dvec3(reduction);
  coarse.originMm = indexToWorld(grid, 0.5 * glm::dvec3(reduction - 1));
  return coarse;
}

/// Adds up a plane of boxes: voxels of one type in, scalars out.
template <class T>
void addPlane(const StoredVoxels<T>& stored, const glm::ivec3& dims, const glm::ivec3& reduction, int plane,
              std::vector<double>& sums) {
  const glm::ivec3 coarse = reducedDims(dims, reduction);
  const int end = std::min((plane + 1) * reduction.z, dims.z);
  for (int z = plane * reduction.z; z < end; ++z)
    for (int y = 0; y < dims.y; ++y) {
      const T* row = &stored[voxelOffset(dims, 0, y, z)];
      double* out = &sums[voxelOffset(coarse, 0, y / reduction.y, plane)];
      for (int x = 0, box = 0; x < dims.x; ++box)
        for (const int boxEnd = std::min(x + reduction.x, dims.x); x < boxEnd; ++x)
          out[box] += static_cast<double>(row[x]);
    }
}

// How many voxels of the volume a box along one axis holds.
int boxLength(int dims, int reduction, int box) {
  return std::min(reduction, dims - box * reduction);
}

} // namespace

glm::ivec3 reductionTo(const Grid& grid, std::size_t most) {
  glm::ivec3 reduction(1);
  while (countOf(reducedDims(grid.dims, reduction)) > most) {
    int finest = -1;
    for (int axis = 0; axis < 3; ++axis)
      if (reduction[axis] < grid.dims[axis] &&
          (finest < 0 || reduction[axis] * grid.spacingMm[axis] < reduction[finest] * grid.spacingMm[finest]))
        finest = axis;
    ++reduction[finest];
  }
  return reduction;
}

std::shared_ptr<const Volume> reduced(const std::shared_ptr<const Volume>& volume,
                                      const glm::ivec3& reduction, const Effort& effort) {
  if (reduction == glm::ivec3(1))
    return volume;
  const glm::ivec3 dims = volume->grid().dims;
  const Grid coarse = reducedGrid(volume->grid(), reduction);
  const Rescale& rescale = volume->rescale();
  std::vector<double> values(countOf(coarse.dims), 0.0);
  forEachPiece(coarse.dims.z, effort, [&](int plane) {
    visitVoxels(*volume, [&](const auto& stored) { addPlane(stored, dims, reduction, plane, values); });
    const int depth = boxLength(dims.z, reduction.z, plane);
    for (int y = 0; y < coarse.dims.y; ++y)
      for (int x = 0; x < coarse.dims.x; ++x) {
        const double count = static_cast<double>(depth) * boxLength(dims.y, reduction.y, y) *
                             boxLength(dims.x, reduction.x, x);
        double& value = values[voxelOffset(coarse.dims, x, y, plane)];
        value = rescale.slope * (value / count) + rescale.intercept;
      }
  });
  return std::make_shared<const Volume>(coarse, std::move(values), Rescale{}, std::nullopt, volume->info());
}

Region reduced(const Region& region, const glm::ivec3& reduction) {
  if (!region.labels || reduction == glm::ivec3(1))
    return region;
  const LabelMap& map = *region.labels;
  const glm::ivec3 coarse = reducedDims(map.dims(), reduction);
  std::vector<std::uint16_t> places;
  places.reserve(countOf(coarse));
  for (int z = 0; z < coarse.z; ++z)
    for (int y = 0; y < coarse.y; ++y)
      for (int x = 0; x < coarse.x; ++x) {
        const glm::ivec3 middle = glm::min(glm::ivec3(x, y, z) * reduction + reduction / 2, map.dims() - 1);
        places.push_back(
            static_cast<std::uint16_t>(map.placeAt(voxelOffset(map.dims(), middle.x, middle.y, middle.z))));
      }
  Region coarser = region;
  coarser.labels = std::make_shared<const LabelMap>(coarse, std::move(places), map.labels());
  return coarser;
}

} // namespace limn
