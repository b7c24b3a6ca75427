// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <algorithm>
#include <cmath>

namespace limn {

/// The power of two, value/mm, in which moduli are computed: about the steepest that the volume can hold, so
/// that neither squares nor floats overflow or vanish, however large or small its values. Multiplying by it
/// is exact.
inline double modulusUnit(const Volume& volume) {
  const double steepest = (volume.range().highest - volume.range().lowest) / smallestSpacingMm(volume.grid());
  return std::ldexp(1.0, std::clamp(std::ilogb(steepest), -1000, 1000));
}

/// Voxels of one volume in their stored type, with differences in scalar units: the gradient of DEFINITION
/// section 2 along the grid's axes.
template <class T>
struct Stencil {
  const Volume& volume;
  const StoredVoxels<T>& stored;
  double perUnit = 1.0 / modulusUnit(volume);
  glm::ivec3 dims = volume.grid().dims;
  std::size_t stride[3] = {1, static_cast<std::size_t>(dims.x), static_cast<std::size_t>(dims.x) * dims.y};

  /// Derivative along one grid axis at a voxel, value/mm.
  double derivative(std::size_t offset, int index, int axis) const {
    const bool hasLower = index > 0;
    const bool hasUpper = index + 1 < dims[axis];
    const int distance = int(hasLower) + int(hasUpper);
    const double upper = static_cast<double>(stored[offset + (hasUpper ? stride[axis] : 0)]);
    const double lower = static_cast<double>(stored[offset - (hasLower ? stride[axis] : 0)]);
    if (upper == lower) // also along an axis of one voxel
      return 0.0;
    return volume.rescale().slope * (upper - lower) / (distance * volume.grid().spacingMm[axis]);
  }

  glm::dvec3 alongAxes(int i, int j, int k) const {
    const std::size_t offset = voxelOffset(dims, i, j, k);
    return {derivative(offset, i, 0), derivative(offset, j, 1), derivative(offset, k, 2)};
  }

  /// In units of `modulusUnit`.
  double modulus(int i, int j, int k) const { return glm::length(alongAxes(i, j, k) * perUnit); }
};

} // namespace limn
