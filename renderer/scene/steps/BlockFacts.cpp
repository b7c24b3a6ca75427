// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/BlockFacts.h"

#include "scene/light/Gradient.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

// Stored voxels and what a block gathers of them, in stored units per voxel until it is finished.
template <class T>
struct Gatherer {
  const std::vector<T>& stored;
  glm::ivec3 dims;
  glm::dvec3 spacing;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  glm::dvec3 steepest{0.0}; // along each axis
  double bend = 0.0;        // squared, per mm²

  void add(const glm::ivec3& index, const glm::ivec3& last) {
    const std::size_t strides[3] = {1, static_cast<std::size_t>(dims.x),
                                    static_cast<std::size_t>(dims.x) * dims.y};
    const std::size_t offset = voxelOffset(dims, index.x, index.y, index.z);
    const auto here = static_cast<double>(stored[offset]);
    lowest = std::min(lowest, here);
    highest = std::max(highest, here);
    double squares = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      // Beyond the outermost centres the field is constant.
      const double up =
          index[axis] + 1 < dims[axis] ? static_cast<double>(stored[offset + strides[axis]]) - here : 0.0;
      const double down = index[axis] > 0 ? here - static_cast<double>(stored[offset - strides[axis]]) : 0.0;
      if (index[axis] < last[axis])
        steepest[axis] = std::max(steepest[axis], std::abs(up));
      const double bent = (up - down) / (spacing[axis] * spacing[axis]);
      squares += bent * bent;
    }
    bend = std::max(bend, squares);
  }

  FieldFacts finished(const Rescale& rescale) const {
    const double slope = std::abs(rescale.slope);
    const double a = rescale.slope * lowest + rescale.intercept;
    const double b = rescale.slope * highest + rescale.intercept;
    return {
        {std::min(a, b), std::max(a, b)}, slope * glm::length(steepest / spacing), slope * std::sqrt(bend)};
  }
};

template <class T>
FieldFacts factsOf(const Volume& volume, const std::vector<T>& stored, const glm::ivec3& block) {
  const Grid& grid = volume.grid();
  Gatherer<T> gatherer{stored, grid.dims, grid.spacingMm};
  const glm::ivec3 first = block * factCells;
  const glm::ivec3 last = glm::min(first + factCells, grid.dims - 1);
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i)
        gatherer.add({i, j, k}, last);
  return gatherer.finished(volume.rescale());
}

} // namespace

BlockFacts blockFacts(const Volume& volume, const Effort& effort) {
  BlockFacts result;
  result.commonPerMm = steepness(volume);
  const glm::ivec3 cells = glm::max(volume.grid().dims - 1, glm::ivec3(1));
  const glm::ivec3 blocks = result.blocks = (cells + factCells - 1) / factCells;
  result.facts.resize(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z);
  const RowPieces rows(blocks, factCells * factCells * factCells);
  visitVoxels(volume, [&]<class T>(const std::vector<T>& stored) {
    forEachPiece(rows.pieces(), effort, [&](int piece) {
      rows.forEachRow(piece, [&](int j, int k) {
        for (int i = 0; i < blocks.x; ++i)
          result.facts[voxelOffset(blocks, i, j, k)] = factsOf(volume, stored, {i, j, k});
      });
    });
  });
  return result;
}

} // namespace limn
