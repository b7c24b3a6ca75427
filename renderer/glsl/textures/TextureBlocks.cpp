// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/TextureBlocks.h"

#include "scene/steps/BlockGatherer.h"
#include "scene/volume/RowPieces.h"
#include "scene/volume/Volume.h"

#include <algorithm>

namespace limn {

glm::ivec2 planesOfLayer(const glm::ivec3& size, int layer) {
  const int first = layer * blockSize;
  return {first, std::min(first + blockSize + 3, size.z)};
}

void gatherLayers(const float* texels, const glm::ivec3& size, int first, int end, BlockRanges& ranges) {
  const glm::ivec3 blocks = ranges.blocks();
  const int firstPlane = planesOfLayer(size, first).x;
  const RowPieces rows({blocks.x, blocks.y, end - first}, blockSize * blockSize * blockSize);
  shareOut(rows.pieces(), {}, [&](Pieces& pieces) {
    BlockGatherer<float> own(size - 2);
    BlockGatherer<float> around(size - 2, 1);
    for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
      rows.forEachRow(piece, [&](int j, int layer) {
        const int k = first + layer;
        const auto rowAt = [&](int x) {
          return [&, x](int y, int z) { return texels + voxelOffset(size, x, y + 1, z + 1 - firstPlane); };
        };
        own.gather(j, k, rowAt(1));
        around.gather(j, k, rowAt(0));
        for (int i = 0; i < blocks.x; ++i) {
          // Beyond a face the texels there weigh no more than the margin, along each of three axes.
          const float lowest = around.lowest(i);
          const float highest = around.highest(i);
          const float beyond = 3.0f * blockMargin * (highest - lowest);
          ranges.set({i, j, k},
                     {std::max(own.lowest(i) - beyond, lowest), std::min(own.highest(i) + beyond, highest)});
        }
      });
  });
}

} // namespace limn
