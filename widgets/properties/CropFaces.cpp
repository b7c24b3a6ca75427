// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/CropFaces.h"

#include <algorithm>
#include <cmath>

namespace limn {

double placeOf(const CropBox& crop, CropFace face) {
  return (face.isUpper ? crop.upper : crop.lower)[face.axis];
}

CropBox withFaceAt(const CropBox& crop, const Grid& grid, CropFace face, double fraction) {
  const int axis = face.axis;
  const double thinnest = 1.0 / grid.dims[axis];
  CropBox edited = crop;
  if (face.isUpper)
    edited.upper[axis] = std::clamp(fraction, std::min(1.0, crop.lower[axis] + thinnest), 1.0);
  else
    edited.lower[axis] = std::clamp(fraction, 0.0, std::max(0.0, crop.upper[axis] - thinnest));
  return edited;
}

double shareLeft(const CropBox& crop) {
  const glm::dvec3 size = crop.upper - crop.lower;
  return size.x * size.y * size.z;
}

VoxelSpan voxelsInside(const CropBox& crop, const Grid& grid, int axis) {
  // The centre of voxel i lies at the fraction (i + ½)/n; the small term keeps a face on a voxel's border
  // from falling to either side by rounding.
  const double n = grid.dims[axis];
  const double first = std::ceil(crop.lower[axis] * n - 0.5 - 1e-9);
  const double last = std::ceil(crop.upper[axis] * n - 0.5 - 1e-9) - 1.0;
  return {static_cast<int>(first) + 1, static_cast<int>(last) + 1};
}

} // namespace limn
