// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/BitGrid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <vector>

namespace limn {
namespace {

using Word = BitGrid::Word;

constexpr double mostHalfAxis = 6.0;

// A row of an ellipsoid: where it lies, beside the middle one.
struct RowOffset {
  int y = 0;
  int z = 0;
};

// The rows of an ellipsoid by how many voxels each reaches to either side.
using EllipsoidRows = std::map<int, std::vector<RowOffset>>;

double squareShare(int offset, double radius) {
  return offset == 0 ? 0.0 : radius > 0.0 ? (offset / radius) * (offset / radius) : 2.0;
}

EllipsoidRows rowsOf(const glm::dvec3& radii) {
  EllipsoidRows rows;
  const glm::ivec3 reach(glm::floor(radii));
  for (int z = -reach.z; z <= reach.z; ++z)
    for (int y = -reach.y; y <= reach.y; ++y) {
      const double left = 1.0 - squareShare(y, radii.y) - squareShare(z, radii.z);
      // A voxel that lies on the ellipsoid belongs to it, however its square is rounded.
      if (left > -1e-9)
        rows[static_cast<int>(radii.x * std::sqrt(std::max(left, 0.0)) + 1e-9)].push_back({y, z});
    }
  return rows;
}

// ORs `from` into `to`, moved by `shift` voxels: -63..63, upwards where positive.
void orMoved(const Word* from, Word* to, int words, int shift) {
  const int up = shift & (BitGrid::wordBits - 1), down = BitGrid::wordBits - up;
  if (shift == 0)
    for (int w = 0; w < words; ++w)
      to[w] |= from[w];
  else if (shift > 0)
    for (int w = 0; w < words; ++w)
      to[w] |= from[w] << up | (w > 0 ? from[w - 1] >> down : 0);
  else
    for (int w = 0; w < words; ++w)
      to[w] |= from[w] >> down | (w + 1 < words ? from[w + 1] << up : 0);
}

// Every voxel of a row whose distance to one of the set is at most `reach`, which stays below half a word.
void widenRow(const Word* from, Word* to, int words, int reach) {
  std::fill(to, to + words, 0);
  for (int shift = -reach; shift <= reach; ++shift)
    orMoved(from, to, words, shift);
}

BitGrid widened(const BitGrid& set, int reach, const Effort& effort) {
  BitGrid wide = set.emptyLike();
  forEachPiece(set.dims().z, effort, [&](int z) {
    for (int y = 0; y < set.dims().y; ++y) {
      widenRow(set.row(y, z), wide.row(y, z), set.rowWords(), reach);
      wide.row(y, z)[set.rowWords() - 1] &= set.voxelsOfWord(set.rowWords() - 1);
    }
  });
  return wide;
}

BitGrid dilatedOnce(const BitGrid& set, const glm::dvec3& radii, const Effort& effort) {
  const glm::ivec3& dims = set.dims();
  BitGrid result = set.emptyLike();
  const EllipsoidRows groups = rowsOf(radii);
  double done = 0.0;
  for (const auto& [reach, offsets] : groups) {
    const double from = done / static_cast<double>(groups.size()),
                 to = ++done / static_cast<double>(groups.size());
    const BitGrid wide = widened(set, reach, partOf(effort, from, 0.5 * (from + to)));
    forEachPiece(dims.z, partOf(effort, 0.5 * (from + to), to), [&, &rows = offsets](int z) {
      for (const RowOffset& offset : rows) {
        if (z + offset.z < 0 || z + offset.z >= dims.z)
          continue;
        for (int y = std::max(0, -offset.y); y < std::min(dims.y, dims.y - offset.y); ++y)
          orMoved(wide.row(y + offset.y, z + offset.z), result.row(y, z), set.rowWords(), 0);
      }
    });
  }
  return result;
}

} // namespace

BitGrid::BitGrid(const glm::ivec3& dims, const std::shared_ptr<Room>& room)
    : m_dims(dims), m_rowWords((dims.x + wordBits - 1) / wordBits),
      m_words(static_cast<std::size_t>(m_rowWords) * dims.y * dims.z, 0, room) {}

bool BitGrid::at(const glm::ivec3& voxel) const {
  return (row(voxel.y, voxel.z)[voxel.x / wordBits] >> (voxel.x % wordBits) & 1) != 0;
}

void BitGrid::set(const glm::ivec3& voxel) {
  row(voxel.y, voxel.z)[voxel.x / wordBits] |= Word{1} << (voxel.x % wordBits);
}

BitGrid::Word BitGrid::voxelsOfWord(int w) const {
  const int voxels = m_dims.x - w * wordBits;
  return voxels >= wordBits ? ~Word{0} : (Word{1} << voxels) - 1;
}

std::size_t BitGrid::count() const {
  std::size_t sum = 0;
  for (const Word word : m_words)
    sum += std::popcount(word);
  return sum;
}

BitGrid& BitGrid::operator|=(const BitGrid& other) {
  for (std::size_t n = 0; n < m_words.size(); ++n)
    m_words[n] |= other.m_words[n];
  return *this;
}

BitGrid& BitGrid::operator&=(const BitGrid& other) {
  for (std::size_t n = 0; n < m_words.size(); ++n)
    m_words[n] &= other.m_words[n];
  return *this;
}

BitGrid& BitGrid::operator-=(const BitGrid& other) {
  for (std::size_t n = 0; n < m_words.size(); ++n)
    m_words[n] &= ~other.m_words[n];
  return *this;
}

BitGrid BitGrid::complement() const {
  BitGrid others = emptyLike();
  for (std::size_t n = 0; n < m_words.size(); ++n)
    others.m_words[n] = ~m_words[n] & voxelsOfWord(static_cast<int>(n % m_rowWords));
  return others;
}

BitGrid dilated(const BitGrid& set, const glm::dvec3& radii, const Effort& effort) {
  const double largest = std::max({radii.x, radii.y, radii.z});
  const int parts = std::max(1, static_cast<int>(std::ceil(largest / mostHalfAxis)));
  BitGrid result = set;
  for (int part = 0; part < parts; ++part)
    result = dilatedOnce(result, radii / static_cast<double>(parts),
                         partOf(effort, static_cast<double>(part) / parts, (part + 1.0) / parts));
  return result;
}

BitGrid eroded(const BitGrid& set, const glm::dvec3& radii, const Effort& effort) {
  return dilated(set.complement(), radii, effort).complement();
}

BitGrid opened(const BitGrid& set, const glm::dvec3& radii, const Effort& effort) {
  return dilated(eroded(set, radii, partOf(effort, 0.0, 0.5)), radii, partOf(effort, 0.5, 1.0));
}

BitGrid closed(const BitGrid& set, const glm::dvec3& radii, const Effort& effort) {
  return eroded(dilated(set, radii, partOf(effort, 0.0, 0.5)), radii, partOf(effort, 0.5, 1.0));
}

} // namespace limn
