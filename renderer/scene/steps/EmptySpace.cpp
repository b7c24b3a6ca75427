// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/EmptySpace.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// By this much of the volume's range may a filtered texel leave the range of its neighbours.
constexpr float textureRounding = 1e-5f;

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

using Distances = std::vector<std::uint8_t>;

std::uint8_t oneMore(std::uint8_t distance) {
  return static_cast<std::uint8_t>(std::min<int>(distance + 1, farthestBlock));
}

// Writes to `to` the least of each element of a row and its neighbours.
void leastOfThree(const std::uint8_t* from, int size, std::uint8_t* to) {
  to[0] = from[0];
  for (int i = 1; i < size; ++i)
    to[i] = std::min(from[i - 1], from[i]);
  for (int i = 0; i + 1 < size; ++i)
    to[i] = std::min(to[i], from[i + 1]);
}

void lowerTo(const std::uint8_t* bound, int size, std::uint8_t* row) {
  for (int i = 0; i < size; ++i)
    row[i] = std::min(row[i], oneMore(bound[i]));
}

// Lowers each distance to one more than that of its neighbours before it in raster order (side -1) or behind
// it (side 1): the nine of the plane there, the three of the row there, and the one in its own row.
void lowerFrom(int side, const glm::ivec3& blocks, Distances& distances) {
  const auto rowAt = [&](int j, int k) { return &distances[voxelOffset(blocks, 0, j, k)]; };
  Distances threes(static_cast<std::size_t>(blocks.x) * blocks.y); // of each row of the plane before
  Distances three(static_cast<std::size_t>(blocks.x));
  for (int n = 0; n < blocks.z; ++n) {
    const int k = side < 0 ? n : blocks.z - 1 - n;
    if (n > 0)
      for (int j = 0; j < blocks.y; ++j)
        leastOfThree(rowAt(j, k + side), blocks.x, &threes[voxelOffset(blocks, 0, j, 0)]);
    for (int m = 0; m < blocks.y; ++m) {
      const int j = side < 0 ? m : blocks.y - 1 - m;
      std::uint8_t* row = rowAt(j, k);
      for (int near = std::max(0, j - 1); n > 0 && near <= std::min(blocks.y - 1, j + 1); ++near)
        lowerTo(&threes[voxelOffset(blocks, 0, near, 0)], blocks.x, row);
      if (m > 0) {
        leastOfThree(rowAt(j + side, k), blocks.x, three.data());
        lowerTo(three.data(), blocks.x, row);
      }
      for (int l = 1; l < blocks.x; ++l) {
        const int x = side < 0 ? l : blocks.x - 1 - l;
        row[x] = std::min(row[x], oneMore(row[x + side]));
      }
    }
  }
}

} // namespace

void spreadDistances(const glm::ivec3& blocks, std::vector<std::uint8_t>& distances) {
  // Two passes in opposite order: chessboard metric, exact.
  lowerFrom(-1, blocks, distances);
  lowerFrom(1, blocks, distances);
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
      // A ray that enters the volume at or above the isovalue is hit where it enters, so a block beyond it is
      // not empty; no ray goes on behind one.
      isEmpty = isEmpty && *visibility.isovalue > range.y + textureRounding;
    distances.push_back(isEmpty ? farthestBlock : std::uint8_t{0});
  }
  spreadDistances(ranges.blocks, distances);
  return distances;
}

BlockBox visibleBlocks(const glm::ivec3& blocks, const std::vector<std::uint8_t>& distances) {
  BlockBox box{blocks, glm::ivec3(0)};
  for (int k = 0; k < blocks.z; ++k)
    for (int j = 0; j < blocks.y; ++j)
      for (int i = 0; i < blocks.x; ++i)
        if (distances[voxelOffset(blocks, i, j, k)] == 0) {
          box.lower = glm::min(box.lower, glm::ivec3(i, j, k));
          box.upper = glm::max(box.upper, glm::ivec3(i, j, k) + 1);
        }
  return glm::any(glm::lessThanEqual(box.upper, box.lower)) ? BlockBox{} : box;
}

} // namespace limn
