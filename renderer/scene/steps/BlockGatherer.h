// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/BlockRanges.h"

#include <algorithm>

namespace limn {

/// Finds the lowest and highest texel of each block, the texels on its faces included.
template <class T>
class BlockGatherer {
public:
  /// Also looks at `margin` texels beyond the faces of each block. The volume must have so many on every
  /// side.
  explicit BlockGatherer(const glm::ivec3& texels, int margin = 0)
      : m_texels(texels), m_margin(margin), m_lowest(static_cast<std::size_t>(texels.x + 2 * margin)),
        m_highest(m_lowest.size()) {}

  /// Looks at the row of blocks (j, k). `rowAt(y, z)` points to the first texel of a row along x, which with
  /// a margin lies before texel 0.
  template <class RowAt>
  void gather(int j, int k, RowAt&& rowAt) {
    const glm::ivec2 inner = glm::ivec2(j, k) * blockSize;
    const glm::ivec2 first = inner - m_margin;
    const glm::ivec2 last = glm::min(inner + blockSize, glm::ivec2(m_texels.y, m_texels.z) - 1) + m_margin;
    std::copy_n(rowAt(first.x, first.y), m_lowest.size(), m_lowest.begin());
    m_highest = m_lowest;
    for (int z = first.y; z <= last.y; ++z)
      for (int y = first.x; y <= last.x; ++y)
        join(rowAt(y, z), m_lowest.size(), m_lowest.data(), m_highest.data());
  }

  /// Of block i in the row gathered last.
  T lowest(int i) const { return *std::min_element(m_lowest.begin() + first(i), m_lowest.begin() + end(i)); }
  T highest(int i) const {
    return *std::max_element(m_highest.begin() + first(i), m_highest.begin() + end(i));
  }

private:
  static void join(const T* row, std::size_t size, T* lowest, T* highest) {
    for (std::size_t x = 0; x < size; ++x) {
      lowest[x] = std::min(lowest[x], row[x]);
      highest[x] = std::max(highest[x], row[x]);
    }
  }

  std::ptrdiff_t first(int i) const { return std::ptrdiff_t{i} * blockSize; }
  std::ptrdiff_t end(int i) const {
    return std::min<std::ptrdiff_t>(first(i) + blockSize + 1, m_texels.x) + 2 * m_margin;
  }

  glm::ivec3 m_texels;
  int m_margin;
  std::vector<T> m_lowest, m_highest;
};

} // namespace limn
