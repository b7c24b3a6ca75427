// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/BlockRanges.h"

#include "scene/volume/RowPieces.h"
#include "scene/volume/Volume.h"

#include <algorithm>
#include <limits>

namespace limn {
namespace {

glm::vec2 joined(const glm::vec2& a, const glm::vec2& b) {
  return {std::min(a.x, b.x), std::max(a.y, b.y)};
}

// Writes the ranges of a row of blocks joined with those of the rows beside it.
void joinRows(const UninitialisedVector<glm::vec2>& ranges, const glm::ivec3& blocks, int j, int k,
              std::vector<glm::vec2>& row) {
  std::copy_n(&ranges[voxelOffset(blocks, 0, j, k)], blocks.x, row.begin());
  for (int z = std::max(0, k - 1); z <= std::min(blocks.z - 1, k + 1); ++z)
    for (int y = std::max(0, j - 1); y <= std::min(blocks.y - 1, j + 1); ++y) {
      const glm::vec2* beside = &ranges[voxelOffset(blocks, 0, y, z)];
      for (std::size_t i = 0; i < row.size(); ++i)
        row[i] = joined(row[i], beside[i]);
    }
}

std::size_t memberOf(const glm::ivec3& block) {
  const glm::ivec3 inside = block % groupSize;
  return voxelOffset(glm::ivec3(groupSize), inside.x, inside.y, inside.z);
}

} // namespace

glm::ivec3 blocksOf(const glm::ivec3& texels) {
  const glm::ivec3 cells = glm::max(texels - 1, glm::ivec3(1));
  return (cells + blockSize - 1) / blockSize;
}

BlockRanges::BlockRanges(const glm::ivec3& blocks)
    : m_blocks(blocks), m_groups((blocks + groupSize - 1) / groupSize) {
  m_members.resize(static_cast<std::size_t>(m_groups.x) * m_groups.y * m_groups.z);
  m_ranges.resize(m_members.size());
}

// The outermost groups have places that no block fills. Only here, in pieces of work: whoever touches the
// first bytes of fresh memory waits until the system has cleared it.
void BlockRanges::fillBeyond(const glm::ivec3& group) {
  const glm::ivec3 inside = m_blocks - group * groupSize;
  if (glm::all(glm::greaterThanEqual(inside, glm::ivec3(groupSize))))
    return;
  Group& members = m_members[groupOffset(group)];
  for (int k = 0; k < groupSize; ++k)
    for (int j = 0; j < groupSize; ++j)
      for (int i = 0; i < groupSize; ++i)
        if (i >= inside.x || j >= inside.y || k >= inside.z) {
          const std::size_t n = voxelOffset(glm::ivec3(groupSize), i, j, k);
          members.lowest[n] = std::numeric_limits<float>::infinity();
          members.highest[n] = -std::numeric_limits<float>::infinity();
        }
}

glm::vec2 BlockRanges::at(const glm::ivec3& block) const {
  const Group& group = m_members[groupOffset(block / groupSize)];
  return {group.lowest[memberOf(block)], group.highest[memberOf(block)]};
}

void BlockRanges::set(const glm::ivec3& block, const glm::vec2& range) {
  Group& group = m_members[groupOffset(block / groupSize)];
  group.lowest[memberOf(block)] = range.x;
  group.highest[memberOf(block)] = range.y;
}

void BlockRanges::finish(const Effort& effort) {
  const RowPieces rows(m_groups, static_cast<int>(Group::size));
  forEachPiece(rows.pieces(), effort, [&](int piece) {
    rows.forEachRow(piece, [&](int j, int k) {
      for (int i = 0; i < m_groups.x; ++i) {
        fillBeyond({i, j, k});
        const std::size_t group = groupOffset({i, j, k});
        const Group& members = m_members[group];
        m_ranges[group] = {*std::min_element(members.lowest.begin(), members.lowest.end()),
                           *std::max_element(members.highest.begin(), members.highest.end())};
      }
    });
  });
}

std::size_t BlockRanges::bytes() const {
  return m_members.size() * sizeof(Group) + m_ranges.size() * sizeof(glm::vec2);
}

BlockRanges widenedByNeighbours(const glm::ivec3& blocks, const UninitialisedVector<glm::vec2>& own,
                                float marginTexels, const Effort& effort) {
  BlockRanges result(blocks);
  const RowPieces rows(blocks);
  forEachPiece(rows.pieces(), effort, [&](int piece) {
    std::vector<glm::vec2> around(static_cast<std::size_t>(blocks.x));
    rows.forEachRow(piece, [&](int j, int k) {
      joinRows(own, blocks, j, k, around);
      const glm::vec2* ranges = &own[voxelOffset(blocks, 0, j, k)];
      for (int i = 0; i < blocks.x; ++i) {
        const auto n = static_cast<std::size_t>(i);
        glm::vec2 near = around[n];
        if (i > 0)
          near = joined(near, around[n - 1]);
        if (i + 1 < blocks.x)
          near = joined(near, around[n + 1]);
        const float beyond = 3.0f * marginTexels * (near.y - near.x);
        result.set({i, j, k},
                   {std::max(ranges[i].x - beyond, near.x), std::min(ranges[i].y + beyond, near.y)});
      }
    });
  });
  result.finish(effort);
  return result;
}

} // namespace limn
