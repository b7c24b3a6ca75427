// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/LabelLooks.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <vector>

// Scenes whose labels have looks of their own, for the tests of every engine, and what they take.

namespace limn::test {

/// Cubes of as many labels beside the first, each with a look.
inline Scene cubesOfLooks(ShadingModel model, int looks, Camera::Projection projection) {
  Scene scene = headScene(phantomVolume({.spacingMm = 3.0}), model);
  scene.camera = orbited(scene.camera, 0.5, 0.3);
  scene.camera.projection = projection;
  std::vector<double> weights(static_cast<std::size_t>(looks) + 1, 1.0);
  weights.back() = 0.6;
  scene.keep = withVariedLooks(cubesRegion(scene.volume->grid().dims, 9, weights), scene.transferFunction);
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.stepVoxels = 0.5;
  return scene;
}

/// Eight labels with looks in cubes of 32 voxels; each shows as much as the scene's own curve, in other
/// colours, so that all rays take the samples that they take without.
inline Scene sceneToTime() {
  Scene scene = headScene(phantomVolume({.spacingMm = 1.5}), ShadingModel::classic);
  scene.camera = orbited(scene.camera, 0.5, 0.3);
  scene.keep = cubesRegion(scene.volume->grid().dims, 32, std::vector<double>(9, 1.0));
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.stepVoxels = 0.5;
  return scene;
}

inline Scene withEightLooks(Scene scene) {
  std::map<std::size_t, TransferFunction> looks;
  for (std::size_t place = 1; place <= 8; ++place) {
    looks[place] = scene.transferFunction;
    for (ControlPoint& point : looks[place].points)
      point.color = glm::dvec3(point.color.b, point.color.r, 0.1 * static_cast<double>(place));
  }
  scene.keep = withLooks(scene.keep, looks);
  return scene;
}

inline double medianLookMs(std::vector<double> times) {
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

template <class Draw>
double lookMsOf(const Draw& draw) {
  const auto begin = std::chrono::steady_clock::now();
  draw();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace limn::test
