// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/PlaneGrid.h"
#include "planes/Reformat.h"
#include "scene/volume/Volume.h"
#include "support/CoveringPlane.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace limn::test {

/// The volume whose voxel (i, j, k) has the scalar that `value` gives.
inline Volume volumeOf(const Grid& grid, const std::function<double(const glm::ivec3&)>& value,
                       const Rescale& rescale = {}) {
  std::vector<float> stored;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        stored.push_back(static_cast<float>(value({i, j, k})));
  return {grid, std::move(stored), rescale, std::nullopt, {}};
}

/// Whole numbers at random, the same every time.
inline Volume noiseOf(const Grid& grid, const Rescale& rescale = {}) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> values(-1000, 3000);
  std::vector<std::int16_t> stored(static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z);
  for (std::int16_t& voxel : stored)
    voxel = static_cast<std::int16_t>(values(random));
  return {grid, std::move(stored), rescale, std::nullopt, {}};
}

/// A grid of `dims` turned about an axis, mm.
inline Grid turnedGrid(const glm::ivec3& dims, const glm::dvec3& spacingMm, double degrees,
                       const glm::dvec3& axis) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = spacingMm;
  grid.originMm = {12.3, -45.6, 78.9};
  grid.direction =
      glm::dmat3(glm::rotate(glm::dmat4(1.0), degrees * std::numbers::pi / 180.0, glm::normalize(axis)));
  return grid;
}

inline Grid plainGrid(const glm::ivec3& dims, const glm::dvec3& spacingMm = glm::dvec3(1.0)) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = spacingMm;
  return grid;
}

} // namespace limn::test
