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

// Ranges of blocks by their own texels, of some planes that follow each other.
class PlanesOfRanges {
public:
  PlanesOfRanges(const glm::ivec3& blocks, int most)
      : m_blocks(blocks), m_ranges(static_cast<std::size_t>(blocks.x) * blocks.y * most) {}

  // Holds the planes `first` … `end`-1 from now on; none of them lies before those that it held.
  void hold(int first, int end, const GatherPlanes& gather, const Effort& effort) {
    std::copy(at(0, 0, first), at(0, 0, m_end), m_ranges.begin());
    m_first = first;
    if (m_end < end)
      gather(m_end, end, &*at(0, 0, m_end), effort);
    m_end = end;
  }

  // Writes a row of blocks joined with those beside it.
  void joinRows(int j, int k, std::vector<glm::vec2>& row) const {
    std::copy_n(rowAt(j, k), m_blocks.x, row.begin());
    for (int z = std::max(0, k - 1); z <= std::min(m_blocks.z - 1, k + 1); ++z)
      for (int y = std::max(0, j - 1); y <= std::min(m_blocks.y - 1, j + 1); ++y) {
        const glm::vec2* beside = rowAt(y, z);
        for (std::size_t i = 0; i < row.size(); ++i)
          row[i] = joined(row[i], beside[i]);
      }
  }

  const glm::vec2* rowAt(int j, int k) const { return &m_ranges[voxelOffset(m_blocks, 0, j, k - m_first)]; }

private:
  UninitialisedVector<glm::vec2>::iterator at(int i, int j, int k) {
    return m_ranges.begin() + static_cast<std::ptrdiff_t>(voxelOffset(m_blocks, i, j, k - m_first));
  }

  glm::ivec3 m_blocks;
  UninitialisedVector<glm::vec2> m_ranges;
  int m_first = 0, m_end = 0;
};

// So many blocks at a time: what is gathered of a large volume does not lie in memory all at once.
constexpr std::int64_t mostBlocksAtOnce = std::int64_t{1} << 21;

std::size_t memberOf(const glm::ivec3& block) {
  const glm::ivec3 inside = block % groupSize;
  return voxelOffset(glm::ivec3(groupSize), inside.x, inside.y, inside.z);
}

// Needs room for a row.
void widenRow(const PlanesOfRanges& own, int j, int k, float marginTexels, std::vector<glm::vec2>& around,
              BlockRanges& result) {
  const int width = result.blocks().x;
  own.joinRows(j, k, around);
  const glm::vec2* ranges = own.rowAt(j, k);
  for (int i = 0; i < width; ++i) {
    const auto n = static_cast<std::size_t>(i);
    glm::vec2 near = around[n];
    if (i > 0)
      near = joined(near, around[n - 1]);
    if (i + 1 < width)
      near = joined(near, around[n + 1]);
    const float beyond = 3.0f * marginTexels * (near.y - near.x);
    result.set({i, j, k}, {std::max(ranges[i].x - beyond, near.x), std::min(ranges[i].y + beyond, near.y)});
  }
}

} // namespace

glm::ivec3 blocksOf(const glm::ivec3& texels) {
  const glm::ivec3 cells = glm::max(texels - 1, glm::ivec3(1));
  return (cells + blockSize - 1) / blockSize;
}

BlockRanges::BlockRanges(const glm::ivec3& blocks, const std::shared_ptr<Room>& room)
    : m_blocks(blocks), m_groups((blocks + groupSize - 1) / groupSize),
      m_members(static_cast<std::size_t>(m_groups.x) * m_groups.y * m_groups.z, room),
      m_ranges(m_members.size(), room) {}

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

BlockRanges widenedByNeighbours(const glm::ivec3& blocks, const GatherPlanes& gather, float marginTexels,
                                const Effort& effort, const std::shared_ptr<Room>& room) {
  BlockRanges result(blocks, room);
  const std::int64_t perPlane = std::int64_t{blocks.x} * blocks.y;
  const auto planes = static_cast<int>(std::clamp<std::int64_t>(mostBlocksAtOnce / perPlane, 1, blocks.z));
  PlanesOfRanges own(blocks, std::min(planes + 2, blocks.z));
  for (int first = 0; first < blocks.z; first += planes) {
    const int end = std::min(first + planes, blocks.z);
    const double before = 0.95 * first / blocks.z, behind = 0.95 * end / blocks.z;
    const double gathered = before + 0.9 * (behind - before);
    own.hold(std::max(0, first - 1), std::min(end + 1, blocks.z), gather, partOf(effort, before, gathered));
    const RowPieces rows({blocks.x, blocks.y, end - first});
    forEachPiece(rows.pieces(), partOf(effort, gathered, behind), [&](int piece) {
      std::vector<glm::vec2> around(static_cast<std::size_t>(blocks.x));
      rows.forEachRow(piece,
                      [&](int j, int k) { widenRow(own, j, first + k, marginTexels, around, result); });
    });
  }
  result.finish(partOf(effort, 0.95, 1.0));
  return result;
}

} // namespace limn
