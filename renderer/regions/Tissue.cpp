// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/Tissue.h"

#include "scene/presets/PresetFit.h"
#include "scene/volume/Histogram.h"

#include <algorithm>

namespace limn {
namespace {

constexpr double tissueHu = -300.0;

template <class T>
BitGrid::Word wordOf(const T* stored, int voxels, const Rescale& rescale, double threshold) {
  BitGrid::Word word = 0;
  for (int n = 0; n < voxels; ++n) {
    const double scalar = rescale.slope * static_cast<double>(stored[n]) + rescale.intercept;
    word |= static_cast<BitGrid::Word>(scalar >= threshold) << n;
  }
  return word;
}

} // namespace

double tissueThreshold(const Volume& volume, const Effort& effort) {
  return looksLikeHounsfield(volume) ? tissueHu : objectThreshold(histogramOf(volume, 1024, effort));
}

BitGrid tissueOf(const Volume& volume, double threshold, const Effort& effort) {
  const glm::ivec3& dims = volume.grid().dims;
  const VoxelMask& invalid = volume.invalidMask();
  BitGrid tissue(dims, volume.room());
  visitVoxels(volume, [&](const auto& stored) {
    forEachPiece(dims.z, effort, [&](int z) {
      for (int y = 0; y < dims.y; ++y)
        for (int w = 0; w < tissue.rowWords(); ++w) {
          const int x = w * BitGrid::wordBits;
          const std::size_t first = voxelOffset(dims, x, y, z);
          BitGrid::Word& word = tissue.row(y, z)[w];
          word = wordOf(&stored[first], std::min(BitGrid::wordBits, dims.x - x), volume.rescale(), threshold);
          if (!invalid.empty())
            word &= ~invalid.from(first);
        }
    });
  });
  return tissue;
}

} // namespace limn
