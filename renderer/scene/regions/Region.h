// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/LabelMap.h"

#include <memory>

namespace limn {

/// Which part of a volume is kept (DEFINITION section 10): one weight for each label, which becomes one more
/// factor of the opacity.
struct Region {
  enum class Kind { all, body, labels };
  Kind kind = Kind::all;
  std::string source;                     ///< of labels: the file that they were read from
  std::shared_ptr<const LabelMap> labels; ///< none where all is kept; of a body: 0 falls away, 1 is kept
  std::vector<double> weights;            ///< 0..1 of each of the labels

  bool operator==(const Region&) const = default;
};

/// Whether the region changes a picture: some label that voxels may have weighs less than 1.
bool isRestricting(const Region& region);

/// The region that keeps `places` 1 of two labels and drops those of 0. `places` has one for each voxel.
Region bodyRegion(const glm::ivec3& dims, StoredVoxels<std::uint8_t> places);

/// The weight at a continuous voxel index: trilinear between voxel centres, clamped to the edge beyond the
/// outermost centres. 1 where there are no labels.
double weightAt(const Region& region, const glm::dvec3& index);

/// The weights of all voxels, x fastest, as 16-bit shares of 1 (0..65535): what renderers read that keep 16
/// bits a voxel. `out` has room for the voxels from `first` on, `count` of them.
void sharesOf(const Region& region, std::size_t first, std::size_t count, std::uint16_t* out);

} // namespace limn
