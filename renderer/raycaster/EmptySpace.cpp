// SPDX-License-Identifier: GPL-3.0-or-later
#include "raycaster/EmptySpace.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int farthest = 255;

// By this much of the volume's range may a filtered texel leave the range of its neighbours.
constexpr float filterRounding = 1e-5f;

// The range of the texels from `from` up to but not including `to`.
glm::vec2 rangeOf(const TextureVoxels& voxels, const glm::ivec3& from, const glm::ivec3& to) {
  glm::vec2 range(3e38f, -3e38f);
  for (int z = from.z; z < to.z; ++z)
    for (int y = from.y; y < to.y; ++y) {
      const float* row = &voxels.texels[voxelOffset(voxels.size, 0, y, z)];
      const auto [low, high] = std::minmax_element(row + from.x, row + to.x);
      range = {std::min(range.x, *low), std::max(range.y, *high)};
    }
  return range;
}

// How many bins up to each one hold an opacity.
std::vector<int> visibleBinsBefore(const PiecewiseTable& function) {
  std::vector<int> before{0};
  for (const glm::vec2& occupancy : function.occupancy)
    before.push_back(before.back() + (occupancy.x > 0.0f ? 1 : 0));
  return before;
}

int binOf(const PiecewiseTable& function, float scalar, float margin) {
  const float bin = std::floor((scalar - function.domain.x) * function.domain.y + margin);
  return static_cast<int>(std::clamp(bin, 0.0f, function.domain.z));
}

// Lowers the distance of a block to one more than that of its neighbours on one side, in raster order.
void lower(std::vector<std::uint8_t>& distances, const glm::ivec3& blocks, const glm::ivec3& at, int side) {
  int nearest = distances[voxelOffset(blocks, at.x, at.y, at.z)];
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const glm::ivec3 n = at + glm::ivec3(i, j, k);
        const bool isBefore = k != 0 ? k == side : j != 0 ? j == side : i == side;
        if (isBefore && glm::all(glm::greaterThanEqual(n, glm::ivec3(0))) &&
            glm::all(glm::lessThan(n, blocks)))
          nearest = std::min(nearest, distances[voxelOffset(blocks, n.x, n.y, n.z)] + 1);
      }
  distances[voxelOffset(blocks, at.x, at.y, at.z)] = static_cast<std::uint8_t>(nearest);
}

} // namespace

BlockRanges blockRanges(const TextureVoxels& voxels) {
  BlockRanges result;
  const glm::ivec3 inner = voxels.size - 2;
  result.blocks = (inner + blockSize - 1) / blockSize;
  result.ranges.reserve(static_cast<std::size_t>(result.blocks.x) * result.blocks.y * result.blocks.z);
  for (int k = 0; k < result.blocks.z; ++k)
    for (int j = 0; j < result.blocks.y; ++j)
      for (int i = 0; i < result.blocks.x; ++i) {
        // Texel 0 is the apron: the block's own begin at 1.
        const glm::ivec3 from = glm::ivec3(i, j, k) * blockSize;
        result.ranges.push_back(rangeOf(voxels, from, glm::min(from + blockSize + 2, voxels.size)));
      }
  return result;
}

std::vector<std::uint8_t> emptyDistances(const BlockRanges& ranges, const Visibility& visibility) {
  std::vector<int> before;
  if (visibility.function)
    before = visibleBinsBefore(*visibility.function);
  std::vector<std::uint8_t> distances;
  distances.reserve(ranges.ranges.size());
  for (const glm::vec2& range : ranges.ranges) {
    bool isEmpty = true;
    if (visibility.function) {
      // A filter rounds: the neighbouring bin may be the one that a sample falls into.
      const int first = binOf(*visibility.function, range.x, -0.01f);
      const int last = binOf(*visibility.function, range.y, 0.01f);
      isEmpty = before[static_cast<std::size_t>(last) + 1] == before[static_cast<std::size_t>(first)];
    }
    if (visibility.isovalue)
      isEmpty = isEmpty && (*visibility.isovalue < range.x - filterRounding ||
                            *visibility.isovalue > range.y + filterRounding);
    distances.push_back(isEmpty ? farthest : 0);
  }
  // Two passes in opposite order spread the distances: chessboard metric, exact.
  const glm::ivec3 b = ranges.blocks;
  for (int k = 0; k < b.z; ++k)
    for (int j = 0; j < b.y; ++j)
      for (int i = 0; i < b.x; ++i)
        lower(distances, b, {i, j, k}, -1);
  for (int k = b.z - 1; k >= 0; --k)
    for (int j = b.y - 1; j >= 0; --j)
      for (int i = b.x - 1; i >= 0; --i)
        lower(distances, b, {i, j, k}, 1);
  return distances;
}

} // namespace limn
