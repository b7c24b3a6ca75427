// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/TextureVoxels.h"

#include "scene/function/PiecewiseTable.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// What lies beyond the outermost of so many inner texels along an axis.
float beyond(float outermost, float next, int inner) {
  return inner > 1 ? 2.0f * outermost - next : outermost;
}

// Writes a row of texels with its ends; each is the mean of its box of voxels.
template <class T>
void fillRow(const StoredVoxels<T>& stored, const Volume& volume, const glm::ivec3& reduction, int j, int k,
             int inner, float* row) {
  const glm::ivec3 dims = volume.grid().dims;
  const Rescale rescale = volume.rescale();
  const ValueRange range = volume.range();
  const auto texelOf = [&](double mean) {
    return static_cast<float>(normalisedValue(range, rescale.slope * mean + rescale.intercept));
  };
  if (reduction == glm::ivec3(1)) {
    const T* voxels = &stored[voxelOffset(dims, 0, j, k)];
    for (int i = 0; i < inner; ++i)
      row[i + 1] = texelOf(static_cast<double>(voxels[i]));
  } else {
    for (int i = 0; i < inner; ++i) {
      const glm::ivec3 from = glm::ivec3(i, j, k) * reduction;
      const glm::ivec3 to = glm::min(from + reduction, dims);
      double sum = 0.0;
      for (int z = from.z; z < to.z; ++z)
        for (int y = from.y; y < to.y; ++y)
          for (int x = from.x; x < to.x; ++x)
            sum += static_cast<double>(stored[voxelOffset(dims, x, y, z)]);
      const glm::ivec3 box = to - from;
      row[i + 1] = texelOf(sum / (static_cast<double>(box.x) * box.y * box.z));
    }
  }
  row[0] = beyond(row[1], row[2], inner);
  row[inner + 1] = beyond(row[inner], row[inner - 1], inner);
}

// Writes the plane of inner texels k with its edges.
template <class T>
void fillInnerPlane(const StoredVoxels<T>& stored, const Volume& volume, const glm::ivec3& reduction, int k,
                    float* plane) {
  const glm::ivec3 inner = reducedDims(volume.grid().dims, reduction);
  const int width = inner.x + 2;
  const auto rowAt = [&](int y) { return plane + static_cast<std::ptrdiff_t>(y) * width; };
  for (int j = 0; j < inner.y; ++j)
    fillRow(stored, volume, reduction, j, k, inner.x, rowAt(j + 1));
  for (int x = 0; x < width; ++x) {
    rowAt(0)[x] = beyond(rowAt(1)[x], rowAt(2)[x], inner.y);
    rowAt(inner.y + 1)[x] = beyond(rowAt(inner.y)[x], rowAt(inner.y - 1)[x], inner.y);
  }
}

// Writes texel plane z; the outermost two are extrapolated.
template <class T>
void fillPlane(const StoredVoxels<T>& stored, const Volume& volume, const glm::ivec3& reduction, int z,
               float* plane) {
  const glm::ivec3 inner = reducedDims(volume.grid().dims, reduction);
  const int nearest = std::clamp(z - 1, 0, inner.z - 1);
  fillInnerPlane(stored, volume, reduction, nearest, plane);
  if (nearest == z - 1 || inner.z == 1)
    return;
  std::vector<float> next((inner.x + std::size_t{2}) * (inner.y + std::size_t{2}));
  fillInnerPlane(stored, volume, reduction, z == 0 ? 1 : inner.z - 2, next.data());
  for (std::size_t i = 0; i < next.size(); ++i)
    plane[i] = beyond(plane[i], next[i], inner.z);
}

} // namespace

glm::ivec3 reducedDims(const glm::ivec3& dims, const glm::ivec3& reduction) {
  return (dims + reduction - 1) / reduction;
}

void fillPlanes(const Volume& volume, const glm::ivec3& reduction, int first, int end, float* to) {
  const glm::ivec3 size = reducedDims(volume.grid().dims, reduction) + 2;
  visitVoxels(volume, [&](const auto& stored) {
    forEachPiece(end - first, {}, [&](int plane) {
      fillPlane(stored, volume, reduction, first + plane, to + voxelOffset(size, 0, 0, plane));
    });
  });
}

TextureVoxels textureVoxels(const Volume& volume, const glm::ivec3& reduction) {
  TextureVoxels voxels;
  voxels.reduction = reduction;
  voxels.size = reducedDims(volume.grid().dims, reduction) + 2;
  voxels.texels.resize(static_cast<std::size_t>(voxels.size.x) * voxels.size.y * voxels.size.z);
  fillPlanes(volume, reduction, 0, voxels.size.z, voxels.texels.data());
  return voxels;
}

float quantised(float texel, const ValueRange& stored, int parts) {
  const double part = (stored.highest - stored.lowest) / parts;
  const double place = (std::clamp<double>(texel, stored.lowest, stored.highest) - stored.lowest) / part;
  return static_cast<float>(stored.lowest + std::round(place) * part);
}

} // namespace limn
