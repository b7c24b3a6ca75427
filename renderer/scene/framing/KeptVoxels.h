// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/volume/Grid.h"
#include "scene/volume/Histogram.h"

#include <cstdint>
#include <vector>

namespace limn {

/// The voxels whose centres lie in the crop.
VoxelBox croppedVoxels(const Grid& grid, const CropBox& crop);

/// The voxels that neither the crop nor the kept region hides: those whose centres lie in the crop and to
/// which the region leaves more than nothing.
class KeptVoxels {
public:
  KeptVoxels(const Grid& grid, const Region& keep, const CropBox& crop);

  /// Whether nothing is hidden.
  bool areAll() const { return m_areAll; }

  bool has(int i, int j, int k) const {
    const bool isInBox = glm::all(glm::greaterThanEqual(glm::ivec3(i, j, k), m_box.lower)) &&
                         glm::all(glm::lessThan(glm::ivec3(i, j, k), m_box.upper));
    return isInBox && (m_isKept.empty() || m_isKept[m_labels->placeAt(voxelOffset(m_dims, i, j, k))]);
  }

private:
  glm::ivec3 m_dims;
  VoxelBox m_box;
  std::shared_ptr<const LabelMap> m_labels;
  std::vector<std::uint8_t> m_isKept; ///< of each label; empty: all
  bool m_areAll;
};

/// The histogram of what is kept, in the bins of histogramOf; a pass over the voxels where something is
/// hidden. Throws Cancelled.
Histogram histogramOfKept(const Volume& volume, const KeptVoxels& kept, int mostBins = 1024,
                          const Effort& effort = {});

/// What of a histogram lies in a range of values, both ends included: other bins are empty.
Histogram heldWithin(Histogram histogram, double lowest, double highest);

/// What of a histogram a curve shows: bins none of whose values have opacity are empty.
Histogram shownBy(const TransferFunction& function, Histogram histogram);

} // namespace limn
