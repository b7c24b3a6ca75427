// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/basics/Room.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace limn {

/// A set of voxels of a grid, one bit each: 512×512×300 voxels take 10 MB, and one instruction asks 64 of
/// them. Rows along x start with a word of their own; the bits behind the last voxel of a row are 0.
class BitGrid {
public:
  using Word = std::uint64_t;
  static constexpr int wordBits = 64;

  /// The empty set on a grid of positive dimensions; its bits lie in the room, or in memory where there is
  /// none.
  explicit BitGrid(const glm::ivec3& dims, const std::shared_ptr<Room>& room = {});

  /// The empty set on the same grid, whose bits lie in the same room.
  BitGrid emptyLike() const { return BitGrid(m_dims, m_words.get_allocator().room()); }

  const glm::ivec3& dims() const { return m_dims; }
  int rowWords() const { return m_rowWords; }

  Word* row(int y, int z) { return m_words.data() + rowOffset(y, z); }
  const Word* row(int y, int z) const { return m_words.data() + rowOffset(y, z); }

  bool at(const glm::ivec3& voxel) const;
  void set(const glm::ivec3& voxel);

  /// The bits of word `w` of a row that belong to voxels.
  Word voxelsOfWord(int w) const;

  std::size_t count() const;

  BitGrid& operator|=(const BitGrid& other);
  BitGrid& operator&=(const BitGrid& other);

  /// Takes the voxels of `other` away.
  BitGrid& operator-=(const BitGrid& other);

  /// The voxels of the grid that are not in the set.
  BitGrid complement() const;

  bool operator==(const BitGrid&) const = default;

private:
  std::size_t rowOffset(int y, int z) const {
    return (static_cast<std::size_t>(z) * m_dims.y + y) * m_rowWords;
  }

  glm::ivec3 m_dims;
  int m_rowWords;
  RoomVector<Word> m_words;
};

/// Every voxel that lies within an ellipsoid around one of the set. `radii` are its half axes in voxels, each
/// ≥ 0. Beyond the grid lies nothing. An ellipsoid of more than 6 voxels is put together from equal smaller
/// ones, as a ball is the sum of two of half its radius; its edge is then off by less than a voxel each.
BitGrid dilated(const BitGrid& set, const glm::dvec3& radii, const Effort& effort);

/// Every voxel around which the whole ellipsoid belongs to the set; what lies beyond the grid counts as if it
/// did, so that a body that the border cuts is not eaten from there.
BitGrid eroded(const BitGrid& set, const glm::dvec3& radii, const Effort& effort);

/// Eroded, then dilated: without what is thinner than the ellipsoid.
BitGrid opened(const BitGrid& set, const glm::dvec3& radii, const Effort& effort);

/// Dilated, then eroded: with the gaps that are thinner than the ellipsoid.
BitGrid closed(const BitGrid& set, const glm::dvec3& radii, const Effort& effort);

} // namespace limn
