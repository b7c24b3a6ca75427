// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/SmoothedField.h"

#include "scene/light/GradientSmoothing.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <utility>

namespace limn {
namespace {

// Writes the sums of a row along x whose neighbours along `axis` are weighed.
void sumRow(const std::vector<double>& from, const glm::ivec3& dims, int axis, int j, int k,
            const std::vector<double>& weights, std::vector<double>& to) {
  for (int i = 0; i < dims.x; ++i) {
    const auto scalarAt = [&](int distance) {
      glm::ivec3 place(i, j, k);
      place[axis] = std::clamp(place[axis] + distance, 0, dims[axis] - 1);
      return from[voxelOffset(dims, place.x, place.y, place.z)];
    };
    double sum = weights[0] * scalarAt(0);
    for (int n = 1; n < static_cast<int>(weights.size()); ++n)
      sum += weights[static_cast<std::size_t>(n)] * (scalarAt(-n) + scalarAt(n));
    to[voxelOffset(dims, i, j, k)] = sum;
  }
}

} // namespace

Volume smoothedField(const Volume& volume, double sigmaMm, const Effort& effort) {
  const Grid& grid = volume.grid();
  std::vector<double> scalars(volume.voxelCount());
  visitVoxels(volume, [&](const auto& stored) {
    for (std::size_t n = 0; n < scalars.size(); ++n)
      scalars[n] = volume.rescale().slope * static_cast<double>(stored[n]) + volume.rescale().intercept;
  });
  std::vector<double> sums(scalars.size());
  const RowPieces rows(grid.dims);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> weights = smoothingWeights(sigmaMm, grid.spacingMm[axis], grid.dims[axis]);
    forEachPiece(rows.pieces(), effort, [&](int piece) {
      rows.forEachRow(piece, [&](int j, int k) { sumRow(scalars, grid.dims, axis, j, k, weights, sums); });
    });
    std::swap(scalars, sums);
  }
  return volume.withScalars(StoredVoxels<double>(std::move(scalars)), {});
}

} // namespace limn
