// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>

namespace limn {

/// The rows of a grid along x, in pieces of work.
class RowPieces {
public:
  /// Of a grid whose elements are `voxelsEach`.
  explicit RowPieces(const glm::ivec3& dims, int voxelsEach = 1)
      : m_height(dims.y), m_rows(std::int64_t{dims.y} * dims.z),
        m_perPiece(std::max(1, voxelsPerPiece / voxelsEach / dims.x)) {}

  int pieces() const { return static_cast<int>((m_rows + m_perPiece - 1) / m_perPiece); }

  /// Calls `function(j, k)` for each row of a piece.
  template <class Function>
  void forEachRow(int piece, Function&& function) const {
    const std::int64_t end = std::min(m_rows, (piece + std::int64_t{1}) * m_perPiece);
    for (std::int64_t row = piece * m_perPiece; row < end; ++row)
      function(static_cast<int>(row % m_height), static_cast<int>(row / m_height));
  }

private:
  int m_height;
  std::int64_t m_rows;
  std::int64_t m_perPiece;
};

} // namespace limn
