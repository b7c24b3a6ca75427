// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/TextureBlocks.h"

#include "scene/steps/BlockGatherer.h"
#include "scene/volume/RowPieces.h"

namespace limn {

BlockRanges blockRanges(const TextureVoxels& voxels) {
  const glm::ivec3 inner = voxels.size - 2; // without the apron
  BlockRanges result(blocksOf(inner));
  const glm::ivec3& blocks = result.blocks();
  const RowPieces rows(blocks, blockSize * blockSize * blockSize);
  shareOut(rows.pieces(), {}, [&](Pieces& pieces) {
    BlockGatherer<float> own(inner);
    BlockGatherer<float> around(inner, 1);
    for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
      rows.forEachRow(piece, [&](int j, int k) {
        const auto rowAt = [&](int x) {
          return [&voxels, x](int y, int z) {
            return &voxels.texels[voxelOffset(voxels.size, x, y + 1, z + 1)];
          };
        };
        own.gather(j, k, rowAt(1));
        around.gather(j, k, rowAt(0));
        for (int i = 0; i < blocks.x; ++i) {
          // Beyond a face the texels there weigh no more than the margin, along each of three axes.
          const float lowest = around.lowest(i);
          const float highest = around.highest(i);
          const float beyond = 3.0f * blockMargin * (highest - lowest);
          result.set({i, j, k},
                     {std::max(own.lowest(i) - beyond, lowest), std::min(own.highest(i) + beyond, highest)});
        }
      });
  });
  result.finish();
  return result;
}

} // namespace limn
