// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/TextureBlocks.h"

#include <algorithm>

namespace limn {
namespace {

glm::vec2 asRange(float value) {
  return glm::vec2(value);
}

glm::vec2 asRange(const glm::vec2& range) {
  return range;
}

// Gathers texels, or ranges of them, along an axis: one range per block, of its own texels and of `margin`
// more on either side. Axis by axis a texel is read a few times instead of once for each of its block's 125.
template <class Value>
std::vector<glm::vec2> gatheredAlong(int axis, const std::vector<Value>& values, glm::ivec3& size, int blocks,
                                     int margin) {
  const std::ptrdiff_t strides[3] = {1, size.x, static_cast<std::ptrdiff_t>(size.x) * size.y};
  const std::ptrdiff_t stride = strides[axis];
  glm::ivec3 gathered = size;
  gathered[axis] = blocks;
  std::vector<glm::vec2> ranges;
  ranges.reserve(static_cast<std::size_t>(gathered.x) * gathered.y * gathered.z);
  for (int k = 0; k < gathered.z; ++k)
    for (int j = 0; j < gathered.y; ++j)
      for (int i = 0; i < gathered.x; ++i) {
        // Texel 0 is the apron: the block's own begin at 1 and end with the first of the next block.
        glm::ivec3 at(i, j, k);
        const int first = at[axis] * blockSize + 1;
        const int last = std::min(first + blockSize, size[axis] - 2);
        at[axis] = first - margin;
        const Value* value = &values[voxelOffset(size, at.x, at.y, at.z)];
        glm::vec2 range = asRange(*value);
        for (int n = first - margin; n < last + margin; ++n) {
          value += stride;
          const glm::vec2 next = asRange(*value);
          range = {std::min(range.x, next.x), std::max(range.y, next.y)};
        }
        ranges.push_back(range);
      }
  size = gathered;
  return ranges;
}

std::vector<glm::vec2> rangesOf(const TextureVoxels& voxels, const glm::ivec3& blocks, int margin) {
  glm::ivec3 size = voxels.size;
  std::vector<glm::vec2> ranges = gatheredAlong(0, voxels.texels, size, blocks.x, margin);
  ranges = gatheredAlong(1, ranges, size, blocks.y, margin);
  return gatheredAlong(2, ranges, size, blocks.z, margin);
}

} // namespace

BlockRanges blockRanges(const TextureVoxels& voxels) {
  BlockRanges result;
  const glm::ivec3 cells = glm::max(voxels.size - 3, glm::ivec3(1));
  result.blocks = (cells + blockSize - 1) / blockSize;
  result.ranges = rangesOf(voxels, result.blocks, 0);
  const std::vector<glm::vec2> around = rangesOf(voxels, result.blocks, 1);
  for (std::size_t i = 0; i < around.size(); ++i) {
    // Beyond a face the texels there weigh no more than the margin, along each of three axes.
    glm::vec2& own = result.ranges[i];
    const float beyond = 3.0f * blockMargin * (around[i].y - around[i].x);
    own = {std::max(own.x - beyond, around[i].x), std::min(own.y + beyond, around[i].y)};
  }
  return result;
}

} // namespace limn
