// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/TextureVoxels.h"

#include "scene/function/PiecewiseTable.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Writes the inner texels, each the mean of its box of voxels.
template <class T>
void fillInner(const std::vector<T>& stored, const Volume& volume, TextureVoxels& voxels) {
  const glm::ivec3 dims = volume.grid().dims;
  const glm::ivec3 inner = voxels.size - 2;
  const Rescale rescale = volume.rescale();
  for (int k = 0; k < inner.z; ++k)
    for (int j = 0; j < inner.y; ++j) {
      float* row = &voxels.texels[voxelOffset(voxels.size, 1, j + 1, k + 1)];
      for (int i = 0; i < inner.x; ++i) {
        const glm::ivec3 from = glm::ivec3(i, j, k) * voxels.reduction;
        const glm::ivec3 to = glm::min(from + voxels.reduction, dims);
        double sum = 0.0;
        for (int z = from.z; z < to.z; ++z)
          for (int y = from.y; y < to.y; ++y)
            for (int x = from.x; x < to.x; ++x)
              sum += static_cast<double>(stored[voxelOffset(dims, x, y, z)]);
        const glm::ivec3 box = to - from;
        const double mean = sum / (static_cast<double>(box.x) * box.y * box.z);
        row[i] =
            static_cast<float>(normalisedValue(volume.range(), rescale.slope * mean + rescale.intercept));
      }
    }
}

// Extrapolates one texel beyond both ends of every line along an axis.
void fillApron(TextureVoxels& voxels, int axis) {
  const glm::ivec3 size = voxels.size;
  const std::ptrdiff_t strides[3] = {1, size.x, static_cast<std::ptrdiff_t>(size.x) * size.y};
  const std::ptrdiff_t stride = strides[axis];
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const int inner = size[axis] - 2;
  for (int b = 0; b < size[v]; ++b)
    for (int a = 0; a < size[u]; ++a) {
      float* line = voxels.texels.data() + a * strides[u] + b * strides[v];
      const float first = line[stride];
      const float last = line[inner * stride];
      line[0] = inner > 1 ? 2.0f * first - line[2 * stride] : first;
      line[(inner + 1) * stride] = inner > 1 ? 2.0f * last - line[(inner - 1) * stride] : last;
    }
}

} // namespace

glm::ivec3 reducedDims(const glm::ivec3& dims, const glm::ivec3& reduction) {
  return (dims + reduction - 1) / reduction;
}

TextureVoxels textureVoxels(const Volume& volume, const glm::ivec3& reduction) {
  TextureVoxels voxels;
  voxels.reduction = reduction;
  voxels.size = reducedDims(volume.grid().dims, reduction) + 2;
  voxels.texels.resize(static_cast<std::size_t>(voxels.size.x) * voxels.size.y * voxels.size.z);
  visitVoxels(volume, [&](const auto& stored) { fillInner(stored, volume, voxels); });
  for (int axis = 0; axis < 3; ++axis)
    fillApron(voxels, axis);
  return voxels;
}

void quantise(TextureVoxels& voxels, const ValueRange& stored, int parts) {
  const double part = (stored.highest - stored.lowest) / parts;
  for (float& texel : voxels.texels) {
    const double place = (std::clamp<double>(texel, stored.lowest, stored.highest) - stored.lowest) / part;
    texel = static_cast<float>(stored.lowest + std::round(place) * part);
  }
}

} // namespace limn
