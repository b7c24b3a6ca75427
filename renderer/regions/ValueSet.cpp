// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/ValueSet.h"

#include <algorithm>

namespace limn {
namespace {

template <class T>
BitGrid::Word wordOf(const T* stored, int voxels, const Rescale& rescale, const glm::dvec2& range) {
  BitGrid::Word word = 0;
  for (int n = 0; n < voxels; ++n) {
    const double scalar = rescale.slope * static_cast<double>(stored[n]) + rescale.intercept;
    word |= static_cast<BitGrid::Word>(scalar >= range.x && scalar <= range.y) << n;
  }
  return word;
}

} // namespace

BitGrid valuesWithin(const Volume& volume, const glm::dvec2& range, const Effort& effort) {
  const glm::ivec3& dims = volume.grid().dims;
  const VoxelMask& invalid = volume.invalidMask();
  BitGrid set(dims, volume.room());
  visitVoxels(volume, [&](const auto& stored) {
    forEachPiece(dims.z, effort, [&](int z) {
      for (int y = 0; y < dims.y; ++y)
        for (int w = 0; w < set.rowWords(); ++w) {
          const int x = w * BitGrid::wordBits;
          const std::size_t first = voxelOffset(dims, x, y, z);
          BitGrid::Word& word = set.row(y, z)[w];
          word = wordOf(&stored[first], std::min(BitGrid::wordBits, dims.x - x), volume.rescale(), range);
          if (!invalid.empty())
            word &= ~invalid.from(first);
        }
    });
  });
  return set;
}

} // namespace limn
