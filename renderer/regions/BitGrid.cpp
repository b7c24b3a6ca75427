// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/BitGrid.h"

#include <bit>

namespace limn {

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

} // namespace limn
