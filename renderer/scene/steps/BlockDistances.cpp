// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/BlockDistances.h"

#include "scene/basics/Error.h"
#include "scene/volume/Volume.h"

#include <algorithm>
#include <cstring>

// Distances are made axis by axis: along rows, then from row to row, then from plane to plane. On the way
// from one row or plane to the next a block takes one more than the least of its neighbours there. That is
// exact, because distances within a row or plane differ by at most one from block to block: whoever needs to
// go farther sideways than ahead has gone so before. All loops are over rows of bytes without order.
namespace limn {
namespace {

std::uint8_t plus(std::uint8_t distance, std::uint8_t more) {
  return static_cast<std::uint8_t>(std::min<std::uint8_t>(distance, farthestBlock - more) + more);
}

// A row of distances between margins of `farthestBlock`.
class PaddedRow {
public:
  explicit PaddedRow(int size) : m_bytes(static_cast<std::size_t>(size) + 2 * margin, farthestBlock) {}
  std::uint8_t* begin() { return m_bytes.data() + margin; }

private:
  static constexpr std::size_t margin = 128;
  std::vector<std::uint8_t> m_bytes;
};

void takeNearer(const std::uint8_t* from, int size, int step, std::uint8_t* to) {
  for (int i = 0; i < size; ++i)
    to[i] =
        std::min(from[i], plus(std::min(from[i - step], from[i + step]), static_cast<std::uint8_t>(step)));
}

// From 0 and `farthestBlock` to distances along the row, in strides of 1, 2, 4, … blocks.
void spreadAlongRow(std::uint8_t* row, int size, PaddedRow& from, PaddedRow& to) {
  const bool isAlike = std::memcmp(row, row + 1, static_cast<std::size_t>(size) - 1) == 0;
  if (isAlike)
    return;
  PaddedRow* now = &from;
  PaddedRow* next = &to;
  std::copy_n(row, size, now->begin());
  for (int step = 1; step < std::min(size, 256); step *= 2) {
    takeNearer(now->begin(), size, step, next->begin());
    std::swap(now, next);
  }
  std::copy_n(now->begin(), size, row);
}

// Writes the least of each element of a row and its neighbours.
void leastOfThree(const std::uint8_t* from, int size, std::uint8_t* to) {
  if (size == 1) {
    to[0] = from[0];
    return;
  }
  to[0] = std::min(from[0], from[1]);
  for (int i = 1; i + 1 < size; ++i)
    to[i] = std::min(from[i], std::min(from[i - 1], from[i + 1]));
  to[size - 1] = std::min(from[size - 2], from[size - 1]);
}

// Lowers each element of a row to one more than the least of three beside it.
void lowerToNeighbours(const std::uint8_t* beside, int size, std::uint8_t* row) {
  if (size == 1) {
    row[0] = std::min(row[0], plus(beside[0], 1));
    return;
  }
  row[0] = std::min(row[0], plus(std::min(beside[0], beside[1]), 1));
  for (int i = 1; i + 1 < size; ++i)
    row[i] = std::min(row[i], plus(std::min(beside[i], std::min(beside[i - 1], beside[i + 1])), 1));
  row[size - 1] = std::min(row[size - 1], plus(std::min(beside[size - 2], beside[size - 1]), 1));
}

void lowerTo(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c, int size,
             std::uint8_t* row) {
  for (int i = 0; i < size; ++i)
    row[i] = std::min(row[i], plus(std::min(a[i], std::min(b[i], c[i])), 1));
}

} // namespace

void spreadWithinPlanes(const glm::ivec3& blocks, int first, int end, BlockDistances& distances) {
  PaddedRow from(blocks.x), to(blocks.x);
  for (int k = first; k < end; ++k) {
    const auto rowAt = [&](int j) { return &distances[voxelOffset(blocks, 0, j, k)]; };
    for (int j = 0; j < blocks.y; ++j)
      spreadAlongRow(rowAt(j), blocks.x, from, to);
    for (int j = 0; j + 1 < blocks.y; ++j)
      lowerToNeighbours(rowAt(j), blocks.x, rowAt(j + 1));
    for (int j = blocks.y - 1; j > 0; --j)
      lowerToNeighbours(rowAt(j), blocks.x, rowAt(j - 1));
  }
}

void spreadAcrossPlanes(const glm::ivec3& blocks, BlockDistances& distances, const Effort& effort) {
  std::vector<std::uint8_t> threes(static_cast<std::size_t>(blocks.x) * blocks.y);
  const auto step = [&](int k, int next) {
    if (effort.isCancelled && effort.isCancelled())
      throw Cancelled();
    const auto threesAt = [&](int j) { return &threes[voxelOffset(blocks, 0, j, 0)]; };
    for (int j = 0; j < blocks.y; ++j)
      leastOfThree(&distances[voxelOffset(blocks, 0, j, k)], blocks.x, threesAt(j));
    for (int j = 0; j < blocks.y; ++j)
      lowerTo(threesAt(std::max(0, j - 1)), threesAt(j), threesAt(std::min(blocks.y - 1, j + 1)), blocks.x,
              &distances[voxelOffset(blocks, 0, j, next)]);
  };
  for (int k = 0; k + 1 < blocks.z; ++k)
    step(k, k + 1);
  for (int k = blocks.z - 1; k > 0; --k)
    step(k, k - 1);
}

void spreadDistances(const glm::ivec3& blocks, BlockDistances& distances, const Effort& effort) {
  forEachPiece(blocks.z, effort, [&](int k) { spreadWithinPlanes(blocks, k, k + 1, distances); });
  spreadAcrossPlanes(blocks, distances, effort);
}

} // namespace limn
