// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/BlockLooks.h"

namespace limn {

BlockLooks blockLooks(const LabelMap& labels, const std::vector<std::uint8_t>& lookOf, const BlockGrid& grid,
                      const Effort& effort, const std::shared_ptr<Room>& room) {
  const glm::ivec3& dims = labels.dims();
  const glm::ivec3& blocks = grid.blocks;
  std::vector<LookBits> bitOf;
  for (const std::uint8_t look : lookOf)
    bitOf.push_back(LookBits{1} << look);
  BlockLooks looks(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z, room);
  std::visit(
      [&](const auto& places) {
        forEachPiece(blocks.y * blocks.z, effort, [&](int row) {
          const BlockSpan y = voxelsOfBlock(grid.first.y + row % blocks.y, grid.cells.y, dims.y - 1);
          const BlockSpan z = voxelsOfBlock(grid.first.z + row / blocks.y, grid.cells.z, dims.z - 1);
          LookBits* const ofRow = &looks[static_cast<std::size_t>(row) * blocks.x];
          std::fill_n(ofRow, blocks.x, LookBits{0});
          for (int k = z.begin; k < z.end; ++k)
            for (int j = y.begin; j < y.end; ++j) {
              const auto* line = &places[voxelOffset(dims, 0, j, k)];
              for (int i = 0; i < blocks.x; ++i) {
                const BlockSpan x = voxelsOfBlock(grid.first.x + i, grid.cells.x, dims.x - 1);
                for (int voxel = x.begin; voxel < x.end; ++voxel)
                  ofRow[i] |= bitOf[line[voxel]];
              }
            }
        });
      },
      labels.places());
  return looks;
}

} // namespace limn
