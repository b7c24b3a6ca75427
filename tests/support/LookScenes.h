// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/ReferenceIntegrator.h"
#include "scene/LabelLooks.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <utility>
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

/// The same opacity between two values of a scalar, and none elsewhere.
inline void addBand(TransferFunction& function, double low, double high, double opacity,
                    const glm::dvec3& color) {
  for (const auto& [value, own] : {std::pair(low, 0.0), {low, opacity}, {high, opacity}, {high, 0.0}})
    function.points.push_back({value, color, own});
}

/// Sixteen voxels of 1 mm along y whose value is their index, in four pre-integrated steps; the last eight
/// have a label with a look and a weight of their own.
inline Scene rampOfFourSteps(double weight) {
  std::vector<double> values(16);
  std::iota(values.begin(), values.end(), 0.0);
  Scene scene = rayThrough(columnOf(values, 1.0));
  addBand(scene.transferFunction, 1.0, 2.5, 0.4, glm::dvec3(1.0));
  addBand(scene.transferFunction, 6.0, 7.0, 0.9, glm::dvec3(1.0)); // which the sample at 5.5 misses
  TransferFunction look{2.0, {}};
  addBand(look, 9.0, 10.0, 0.3, glm::dvec3(1.0)); // the one at 9.5 is in it
  addBand(look, 13.0, 14.0, 0.8, glm::dvec3(1.0));
  std::vector<std::uint8_t> places(16, 0);
  std::fill(places.begin() + 8, places.end(), std::uint8_t{1});
  const std::vector<Label> labels{{0, "", glm::dvec3(1.0)}, {1, "", glm::dvec3(1.0)}};
  scene.keep = {Region::Kind::labels,
                "",
                std::make_shared<const LabelMap>(glm::ivec3(1, 16, 1), places, labels),
                {1.0, weight}};
  scene.keep = withLooks(scene.keep, {{1, look}});
  scene.quality.stepVoxels = 4.0;
  scene.quality.preintegrated = Preintegration::always;
  return scene;
}

/// What that absorbs where every opacity counts `factor` times (DEFINITION section 10). The first step goes
/// from 0, for f is clamped at the outermost centre, to 3.5 and the last from 11.5 to 15, each within one
/// look; the two between end at 7.5, where looks meet, so their samples stand for them.
inline double depthOfFourSteps(double weight, double factor) {
  const auto depth = [&](double opacity, double share, double of, double unitMm) {
    const double mean = -std::expm1(share * std::log1p(-opacity));
    return -4.0 * std::log1p(-of * factor * mean) / unitMm;
  };
  return depth(0.4, 1.5 / 3.5, 1.0, 1.0) + depth(0.3, 1.0, weight, 2.0) + depth(0.8, 1.0 / 3.5, weight, 2.0);
}

/// A ramp from front to back in steps of four voxels, half of it of one look and half of another, each with
/// bands of a quarter of what the value changes by in a step; nothing shows where they meet.
inline Scene rampOfTwoLooks() {
  const Grid grid = centredGrid(glm::ivec3(48), glm::dvec3(1.0));
  Scene scene;
  scene.volume = volumeOf(grid, [](int, int j, int) { return j; });
  scene.shading.model = ShadingModel::none;
  const glm::dvec3 orange(1.0, 0.6, 0.2), blue(0.2, 0.5, 1.0);
  for (const double at : {5.0, 13.0})
    addBand(scene.transferFunction, at, at + 1.0, 0.4, orange);
  TransferFunction look;
  for (const double at : {33.0, 41.0})
    addBand(look, at, at + 1.0, 0.4, blue);
  std::vector<std::uint8_t> places;
  for (int voxel = 0; voxel < 48 * 48 * 48; ++voxel)
    places.push_back(voxel / 48 % 48 < 24 ? 0 : 1);
  const std::vector<Label> labels{{0, "", orange}, {1, "", blue}};
  scene.keep = {
      Region::Kind::labels, "", std::make_shared<const LabelMap>(grid.dims, places, labels), {1.0, 1.0}};
  scene.keep = withLooks(scene.keep, {{1, look}});
  scene.camera = orbited(defaultCamera(grid), 0.2, 0.15);
  scene.quality.earlyTermination = 1.0;
  scene.quality.stepVoxels = 4.0;
  return scene;
}

/// The exact picture of that, from cell to cell, which knows nothing of steps.
inline Image exactRamp(const glm::ivec2& size) {
  Scene scene = rampOfTwoLooks();
  scene.quality.toleranceLevels = 0.05;
  return toImage(renderReference(scene, size));
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
