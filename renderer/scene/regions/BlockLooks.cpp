// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/BlockLooks.h"

#include <algorithm>

namespace limn {

BlockLooks blockLooks(const LabelMap& labels, const std::vector<std::uint8_t>& lookOf, const BlockGrid& grid,
                      const Effort& effort, const std::shared_ptr<Room>& room) {
  const glm::ivec3& dims = labels.dims();
  const glm::ivec3& blocks = grid.blocks;
  std::vector<LookBits> bitOf;
  bitOf.reserve(lookOf.size());
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

RoomVector<std::uint8_t> looksOfVoxels(const LabelMap& labels, const std::vector<std::uint8_t>& lookOf,
                                       const Effort& effort, const std::shared_ptr<Room>& room) {
  const glm::ivec3& dims = labels.dims();
  RoomVector<std::uint8_t> looks(static_cast<std::size_t>(dims.x) * dims.y * dims.z, room);
  std::visit(
      [&](const auto& places) {
        forEachPiece(dims.y * dims.z, effort, [&](int row) {
          const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(dims.x);
          for (std::size_t voxel = first; voxel < first + static_cast<std::size_t>(dims.x); ++voxel)
            looks[voxel] = lookOf[places[voxel]];
        });
      },
      labels.places());
  return looks;
}

RoomVector<std::uint8_t> cellLooks(const glm::ivec3& dims, const RoomVector<std::uint8_t>& looks,
                                   const Effort& effort, const std::shared_ptr<Room>& room) {
  RoomVector<std::uint8_t> cells(looks.size(), room);
  forEachPiece(dims.y * dims.z, effort, [&](int row) {
    const int j = row % dims.y, k = row / dims.y;
    const int nextJ = std::min(j + 1, dims.y - 1), nextK = std::min(k + 1, dims.z - 1);
    const std::uint8_t* const here = &looks[voxelOffset(dims, 0, j, k)];
    const std::uint8_t* const above = &looks[voxelOffset(dims, 0, nextJ, k)];
    const std::uint8_t* const behind = &looks[voxelOffset(dims, 0, j, nextK)];
    const std::uint8_t* const both = &looks[voxelOffset(dims, 0, nextJ, nextK)];
    std::uint8_t* const out = &cells[voxelOffset(dims, 0, j, k)];
    for (int i = 0; i < dims.x; ++i) {
      const int next = std::min(i + 1, dims.x - 1);
      const std::uint8_t look = here[i];
      const int others = (here[next] ^ look) | (above[i] ^ look) | (above[next] ^ look) | (behind[i] ^ look) |
                         (behind[next] ^ look) | (both[i] ^ look) | (both[next] ^ look);
      out[i] = others == 0 ? look : severalLooks;
    }
  });
  return cells;
}

} // namespace limn
