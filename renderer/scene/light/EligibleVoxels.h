// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <algorithm>

namespace limn {

/// The voxels whose gradient counts: they and their stencil neighbours are valid (DEFINITION section 1). Told
/// of runs of at most 64 voxels along x at a time.
class EligibleVoxels {
public:
  static constexpr int run = 64;

  explicit EligibleVoxels(const Volume& volume) : m_mask(volume.invalidMask()), m_dims(volume.grid().dims) {}

  /// One bit for each of the `count` voxels from (x, y, z) on, the first the lowest.
  std::uint64_t from(int x, int y, int z, int count) const {
    const std::uint64_t asked = count == run ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
    if (m_mask.empty())
      return asked;
    const std::size_t row = m_dims.x;
    const std::size_t slice = row * m_dims.y;
    const std::size_t at = voxelOffset(m_dims, x, y, z);
    std::uint64_t invalid = m_mask.from(at);
    invalid |= invalid << 1 | (x > 0 && m_mask[at - 1] ? 1 : 0);
    std::uint64_t behind = m_mask.from(at + 1);
    if (x + count == m_dims.x)
      behind &= asked >> 1; // what follows the last is in another row
    invalid |= behind;
    if (y > 0)
      invalid |= m_mask.from(at - row);
    if (y + 1 < m_dims.y)
      invalid |= m_mask.from(at + row);
    if (z > 0)
      invalid |= m_mask.from(at - slice);
    if (z + 1 < m_dims.z)
      invalid |= m_mask.from(at + slice);
    return asked & ~invalid;
  }

  bool has(int x, int y, int z) const { return from(x, y, z, 1) != 0; }

private:
  const VoxelMask& m_mask;
  glm::ivec3 m_dims;
};

} // namespace limn
