// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <functional>

namespace limn::test {

/// A scene of a volume of floats that a function of the world gives at voxel centres.
inline Scene sampledScene(const Grid& grid, const std::function<double(const glm::dvec3& worldMm)>& field) {
  std::vector<float> stored;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        stored.push_back(static_cast<float>(field(indexToWorld(grid, {i, j, k}))));
  Scene scene;
  scene.volume = std::make_shared<Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
  return scene;
}

/// A grid of cubes of voxels, centred on a place of the world.
inline Grid centredGrid(int dims, double spacingMm, const glm::dvec3& centreMm = glm::dvec3(0.0)) {
  Grid grid;
  grid.dims = glm::ivec3(dims);
  grid.spacingMm = glm::dvec3(spacingMm);
  grid.originMm = centreMm - 0.5 * spacingMm * (dims - 1);
  return grid;
}

/// How deep a place lies in a ball, mm.
inline std::function<double(const glm::dvec3&)> ball(const glm::dvec3& centreMm, double radiusMm) {
  return [=](const glm::dvec3& worldMm) { return radiusMm - glm::length(worldMm - centreMm); };
}

} // namespace limn::test
