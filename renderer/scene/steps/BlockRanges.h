// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/basics/Room.h"

#include <glm/glm.hpp>

#include <array>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace limn {

/// Leaves elements that are made without a value as the memory is.
template <class T>
struct UninitialisedAllocator : std::allocator<T> {
  template <class Other>
  struct rebind {
    using other = UninitialisedAllocator<Other>;
  };

  template <class Other>
  void construct(Other*) noexcept {}
  template <class Other, class... Arguments>
  void construct(Other* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
};

/// For large arrays of plain values that are written in pieces of work: filling them beforehand would take
/// longer than anybody may wait who cancels.
template <class T>
using UninitialisedVector = std::vector<T, UninitialisedAllocator<T>>;

/// Cells along each edge of a block.
inline constexpr int blockSize = 4;

/// Blocks along each edge of a group.
inline constexpr int groupSize = 4;

/// By this many texels may a position computed in float lie on the wrong side of a block's face: a hundred
/// times what coordinates of a texture of 2048 texels lose to rounding.
inline constexpr float blockMargin = 1.0f / 128.0f;

/// How many blocks have so many texel centres along each axis.
glm::ivec3 blocksOf(const glm::ivec3& texels);

/// The scalars that samples in each block of 4³ cells between texel centres can take. Neighbours share the
/// texels on their common face; the range stands for positions up to a margin of texels beyond the block, so
/// that rounding there steps over nothing. The outermost blocks also own the half texel before the volume's
/// end, where the field is constant.
class BlockRanges {
public:
  /// The ranges of 4³ blocks, which lie together in memory: whoever asks for one asks for the others.
  struct Group {
    static constexpr std::size_t size = std::size_t{groupSize} * groupSize * groupSize;
    std::array<float, size> lowest;  ///< x fastest; +∞ beyond the last block
    std::array<float, size> highest; ///< -∞ beyond the last block
  };

  BlockRanges() = default;
  /// Every block must be set, then finish() called. They lie in the room given. Throws what Room does.
  explicit BlockRanges(const glm::ivec3& blocks, const std::shared_ptr<Room>& room = {});

  const glm::ivec3& blocks() const { return m_blocks; }
  const glm::ivec3& groups() const { return m_groups; }
  const Group& group(int i, int j, int k) const { return m_members[groupOffset({i, j, k})]; }

  /// Lowest and highest of all blocks of a group.
  const glm::vec2& groupRange(int i, int j, int k) const { return m_ranges[groupOffset({i, j, k})]; }

  glm::vec2 at(const glm::ivec3& block) const;
  void set(const glm::ivec3& block, const glm::vec2& range);

  /// Finds the ranges of the groups, once the blocks have theirs. Throws Cancelled.
  void finish(const Effort& effort = {});

  std::size_t bytes() const;

private:
  void fillBeyond(const glm::ivec3& group);

  std::size_t groupOffset(const glm::ivec3& group) const {
    return (static_cast<std::size_t>(group.z) * m_groups.y + group.y) * m_groups.x + group.x;
  }

  glm::ivec3 m_blocks{0};
  glm::ivec3 m_groups{0};
  RoomVector<Group> m_members;
  RoomVector<glm::vec2> m_ranges;
};

/// Writes the ranges of the blocks in the planes z = `first` … `end`-1 by their own texels alone, x fastest.
using GatherPlanes = std::function<void(int first, int end, glm::vec2* ranges, const Effort& effort)>;

/// From ranges of blocks by their own texels: lets each stand for positions up to `marginTexels` beyond it,
/// where the texels of neighbouring blocks weigh no more than the margin along each of three axes. Asks for
/// some planes at a time, in ascending order, each once. The result lies in the room given. Throws Cancelled;
/// what Room does.
BlockRanges widenedByNeighbours(const glm::ivec3& blocks, const GatherPlanes& gather, float marginTexels,
                                const Effort& effort = {}, const std::shared_ptr<Room>& room = {});

} // namespace limn
