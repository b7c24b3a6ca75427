// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "PlaneVolumes.h"

#include <gtest/gtest.h>

#include <optional>

// Planes as they are defined, pixel by pixel and voxel by voxel: an independent resampling in double
// precision that shares nothing with renderer/planes but the places of pixels.
namespace limn::test {

/// What rounding may decide either way is not compared: on the box's surface, halfway between two voxels.
struct DefinedSample {
  bool isInside = false;
  bool isUncertain = false;
  double value = 0.0;
};

inline DefinedSample definedAt(const Volume& volume, const glm::dvec3& worldMm,
                               PlaneInterpolation interpolation) {
  const Grid& grid = volume.grid();
  constexpr double rounding = 1e-7;
  DefinedSample sample{true, false, 0.0};
  glm::dvec3 index;
  for (int axis = 0; axis < 3; ++axis) {
    index[axis] = glm::dot(grid.direction[axis], worldMm - grid.originMm) / grid.spacingMm[axis];
    const double last = grid.dims[axis] - 0.5;
    sample.isInside = sample.isInside && index[axis] >= -0.5 && index[axis] < last;
    sample.isUncertain = sample.isUncertain || std::abs(index[axis] + 0.5) < rounding ||
                         std::abs(index[axis] - last) < rounding;
    if (interpolation == PlaneInterpolation::nearest)
      sample.isUncertain =
          sample.isUncertain || std::abs(std::abs(index[axis] - std::round(index[axis])) - 0.5) < rounding;
  }
  if (!sample.isInside)
    return sample;
  // Each voxel weighs by a tent one voxel wide to each side; those beyond the edge are the edge's.
  glm::ivec3 first(glm::floor(index));
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1.0;
    glm::ivec3 voxel;
    for (int axis = 0; axis < 3; ++axis) {
      const int at = first[axis] + (corner >> axis & 1);
      const double distance = std::abs(index[axis] - at);
      weight *= interpolation == PlaneInterpolation::linear ? 1.0 - distance : distance < 0.5 ? 1.0 : 0.0;
      voxel[axis] = std::clamp(at, 0, grid.dims[axis] - 1);
    }
    sample.value += weight * volume.value(voxel);
  }
  return sample;
}

/// The same of a slab: parts no thicker than a voxel is along the way across.
inline DefinedSample definedIn(const Volume& volume, const glm::dvec3& worldMm, const glm::dvec3& across,
                               const PlaneSampling& sampling) {
  double voxels = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    voxels = std::max(voxels, std::abs(glm::dot(volume.grid().direction[axis], across)) *
                                  sampling.slab.thicknessMm / volume.grid().spacingMm[axis]);
  int parts = 1;
  while (parts < voxels - 1e-6)
    ++parts;
  DefinedSample result;
  int count = 0;
  for (int part = 0; part < parts; ++part) {
    const double away = sampling.slab.thicknessMm * ((part + 0.5) / parts - 0.5);
    const DefinedSample sample = definedAt(volume, worldMm + away * across, sampling.interpolation);
    result.isUncertain = result.isUncertain || sample.isUncertain;
    if (!sample.isInside)
      continue;
    if (sampling.slab.mode == Slab::Mode::mean)
      result.value += sample.value;
    else
      result.value = count == 0 ? sample.value : std::max(result.value, sample.value);
    ++count;
  }
  result.isInside = count > 0;
  if (sampling.slab.mode == Slab::Mode::mean && count > 0)
    result.value /= count;
  return result;
}

/// Compares a plane with its definition: inside and outside agree, and values to 1e-9 of the volume's range
/// (1e-4 is asked for; sums of eight products in double leave about 1e-15). `stride` takes every n-th pixel.
inline void expectDefined(const Volume& volume, const PlaneGrid& plane, const PlaneSampling& sampling,
                          int stride = 1) {
  const PlaneImage image = reformatted(volume, plane, sampling);
  ASSERT_EQ(image.size, plane.size);
  const glm::dvec3 across = glm::cross(plane.axes.right, plane.axes.down);
  const double width = volume.range().highest - volume.range().lowest;
  double largest = 0.0;
  int compared = 0;
  for (int y = 0; y < plane.size.y; y += stride)
    for (int x = 0; x < plane.size.x; x += stride) {
      const DefinedSample wanted = definedIn(volume, pixelToWorld(plane, {x, y}), across, sampling);
      if (wanted.isUncertain)
        continue;
      ASSERT_EQ(!std::isnan(image.at(x, y)), wanted.isInside) << x << ' ' << y;
      if (!wanted.isInside)
        continue;
      largest = std::max(largest, std::abs(image.at(x, y) - wanted.value));
      ++compared;
    }
  EXPECT_GT(compared, 0);
  EXPECT_LE(largest, 1e-9 * std::max(width, 1.0)) << compared << " pixels";
}

} // namespace limn::test
