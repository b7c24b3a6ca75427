// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/BlockWeights.h"

#include <algorithm>
#include <limits>

namespace limn {
namespace {

// The least and the most of some weights.
struct WeightRange {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void add(double weight) {
    least = std::min(least, weight);
    most = std::max(most, weight);
  }

  BlockWeight kind() const {
    if (least < most)
      return BlockWeight::varying;
    return !(most > 0.0) ? BlockWeight::none : least < 1.0 ? BlockWeight::same : BlockWeight::all;
  }
};

} // namespace

BlockSpan voxelsOfBlock(int block, int cells, int last) {
  return {std::max(0, block * cells - 1), std::min(last, (block + 1) * cells + 1) + 1};
}

BlockWeights blockWeights(const Region& region, const BlockGrid& grid, const Effort& effort,
                          const std::shared_ptr<Room>& room) {
  const glm::ivec3& dims = region.labels->dims();
  const glm::ivec3& blocks = grid.blocks;
  BlockWeights kinds(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z, room);
  std::visit(
      [&](const auto& places) {
        forEachPiece(blocks.y * blocks.z, effort, [&](int row) {
          const BlockSpan y = voxelsOfBlock(grid.first.y + row % blocks.y, grid.cells.y, dims.y - 1);
          const BlockSpan z = voxelsOfBlock(grid.first.z + row / blocks.y, grid.cells.z, dims.z - 1);
          std::vector<WeightRange> ranges(static_cast<std::size_t>(blocks.x));
          for (int k = z.begin; k < z.end; ++k)
            for (int j = y.begin; j < y.end; ++j) {
              const auto* line = &places[(static_cast<std::size_t>(k) * dims.y + j) * dims.x];
              for (int i = 0; i < blocks.x; ++i) {
                const BlockSpan x = voxelsOfBlock(grid.first.x + i, grid.cells.x, dims.x - 1);
                for (int voxel = x.begin; voxel < x.end; ++voxel)
                  ranges[static_cast<std::size_t>(i)].add(region.weights[line[voxel]]);
              }
            }
          std::transform(ranges.begin(), ranges.end(),
                         kinds.begin() + static_cast<std::ptrdiff_t>(row) * blocks.x,
                         [](const WeightRange& range) { return range.kind(); });
        });
      },
      region.labels->places());
  return kinds;
}

} // namespace limn
