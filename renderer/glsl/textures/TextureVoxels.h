// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <vector>

namespace limn {

/// Voxels as the shaders read them: normalised over the volume's range, with an apron of one voxel on every
/// side extrapolated linearly (f[-1] = 2f[0] - f[1]; a copy along an axis of one voxel).
struct TextureVoxels {
  glm::ivec3 size{0};      ///< with the apron
  glm::ivec3 reduction{1}; ///< voxels of the volume per texel, along each axis
  std::vector<float> texels;
};

/// The texels along each axis, without the apron, of a volume reduced by whole factors.
glm::ivec3 reducedDims(const glm::ivec3& dims, const glm::ivec3& reduction);

/// Averages boxes of `reduction` voxels, normalises in double and adds the apron.
TextureVoxels textureVoxels(const Volume& volume, const glm::ivec3& reduction);

/// Writes the planes z = `first` … `end`-1 of those texels to `to`, which has room for them.
void fillPlanes(const Volume& volume, const glm::ivec3& reduction, int first, int end, float* to);

/// Rounds a texel to what a fixed-point texture of so many parts holds whose 0..1 stand for `stored`.
float quantised(float texel, const ValueRange& stored, int parts);

} // namespace limn
