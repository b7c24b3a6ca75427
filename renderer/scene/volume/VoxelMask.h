// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Room.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace limn {

/// One flag per voxel, in the order of the voxels; without any where no voxel has it.
class VoxelMask {
public:
  VoxelMask() = default;
  /// Without any flag yet; they lie in `room`, or in memory where there is none.
  explicit VoxelMask(std::size_t voxels, const std::shared_ptr<Room>& room = {})
      : m_words((voxels + 63) / 64, std::uint64_t{0}, room) {}

  bool empty() const { return m_words.empty(); }
  bool operator[](std::size_t voxel) const { return (m_words[voxel / 64] >> (voxel % 64) & 1) != 0; }

  /// The flags of 64 voxels from `voxel` on, the first in the lowest bit; 0 beyond the last.
  std::uint64_t from(std::size_t voxel) const {
    const std::size_t word = voxel / 64;
    const std::size_t shift = voxel % 64;
    const std::uint64_t low = word < m_words.size() ? m_words[word] >> shift : 0;
    return shift == 0 || word + 1 >= m_words.size() ? low : low | m_words[word + 1] << (64 - shift);
  }

  /// The flags of the voxels 64·n … 64·n+63.
  std::uint64_t& word(std::size_t n) { return m_words[n]; }

private:
  RoomVector<std::uint64_t> m_words;
};

} // namespace limn
