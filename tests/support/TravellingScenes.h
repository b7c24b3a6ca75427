// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/basics/Image.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <optional>
#include <string>

namespace limn::test {

/// A head under a light from above left, behind the viewer, with shadows and occlusion.
inline Scene shadowedHead(double spacingMm, ShadingModel model = ShadingModel::classic) {
  Scene scene = headScene(phantomVolume({.spacingMm = spacingMm}), model);
  scene.camera = orbited(scene.camera, 0.5, 0.3);
  scene.shading.lightDirection = glm::dvec3(0.6, -0.7, 1.0);
  scene.shading.lightAxes = LightAxes::camera;
  scene.shading.shadow = {0.85, 5.0};
  scene.shading.occlusion = {0.8, 15.0};
  scene.quality.stepVoxels = 0.5;
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

inline Scene withoutTravel(Scene scene) {
  scene.shading.shadow = {};
  scene.shading.occlusion = {};
  return scene;
}

/// A ball over a plate, a skull over a jaw with air between, lit through the plate from below; with the plate
/// or with air in its place, whose values and range are the same elsewhere.
inline Scene skullOverJaw(bool hasJaw) {
  Scene scene;
  scene.volume = volumeOf(centredGrid({40, 40, 48}, glm::dvec3(2.0)), [hasJaw](int i, int j, int k) {
    const glm::dvec3 fromMiddle = glm::dvec3(i, j, k) - glm::dvec3(19.5, 19.5, 32.0);
    if (k < 10)
      return hasJaw && k >= 4 && i >= 8 && i < 32 && j >= 8 && j < 32 ? 1000.0 : -1000.0;
    return std::clamp(1000.0 - 400.0 * (glm::length(fromMiddle) - 11.0), -1000.0, 1000.0);
  });
  scene.transferFunction = {1.0, {{-200.0, {0.9, 0.8, 0.7}, 0.0}, {600.0, {0.9, 0.8, 0.7}, 0.6}}};
  scene.camera = orbited(defaultCamera(scene.volume->grid()), 0.3, -0.2);
  scene.shading.lightDirection = glm::dvec3(0.15, 0.2, 1.0);
  scene.shading.shadow = {0.9, 5.0};
  scene.shading.occlusion = {0.8, 40.0};
  scene.quality.stepVoxels = 0.5;
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

/// The same with the jaw cropped away, in the air above it.
inline Scene croppedToSkull(Scene scene) {
  scene.crop.lower.z = 14.0 / 48.0;
  return scene;
}

/// A head of which what lies below a face of the crop is air or tissue; the crop is the same.
inline Scene headCutAtTheJaw(bool hasJaw) {
  Scene scene = shadowedHead(4.0);
  scene.shading.lightDirection = glm::dvec3(0.1, 0.2, 1.0);
  scene.shading.lightAxes = LightAxes::world;
  const glm::ivec3 dims = scene.volume->grid().dims;
  constexpr int cut = 26;
  scene.crop.lower.z = static_cast<double>(cut) / dims.z;
  const Volume& whole = *scene.volume;
  scene.volume = volumeOf(whole.grid(), [&](int i, int j, int k) {
    // At a cut face samples and their gradients read two voxels beyond. One voxel keeps the range of values.
    const bool isJaw = k < cut - 3 && glm::ivec3(i, j, k) != glm::ivec3(0);
    return i + j + k == 0     ? whole.range().highest
           : !hasJaw && isJaw ? whole.range().lowest
                              : whole.value({i, j, k});
  });
  return scene;
}

/// The mean of the colour channels over what a picture covers, in levels.
inline double brightness(const Image& image) {
  double sum = 0.0;
  int covered = 0;
  for (const glm::vec4& pixel : image.pixels)
    if (pixel.a >= 1.0f / 510.0f) {
      sum += static_cast<double>(pixel.r) + pixel.g + pixel.b;
      ++covered;
    }
  return covered > 0 ? 255.0 * sum / (3.0 * covered) : 0.0;
}

/// What such a head may have beside.
struct TravelCase {
  const char* what;
  void (*apply)(Scene&);
};

inline const TravelCase travelCases[] = {
    {"shadow alone", [](Scene& s) { s.shading.occlusion = {}; }},
    {"a hard shadow alone",
     [](Scene& s) {
       s.shading.occlusion = {};
       s.shading.shadow.softnessDeg = 0.0;
     }},
    {"occlusion alone", [](Scene& s) { s.shading.shadow = {}; }},
    {"enhanced, with gradient opacity",
     [](Scene& s) {
       s.shading.model = ShadingModel::enhanced;
       s.gradientOpacity = GradientOpacity{{{0.0, 0.3}, {60.0, 1.0}}};
     }},
    {"cropped, robust, in fog",
     [](Scene& s) {
       s.shading.model = ShadingModel::robust;
       s.crop = {{0.1, 0.3, 0.0}, {0.9, 1.0, 0.8}};
       s.fog = distanceFog(200.0, 900.0);
     }},
    {"up to a surface", [](Scene& s) { s.projection = Projection::compositeIsosurface; }},
    {"a surface", [](Scene& s) { s.projection = Projection::isosurface; }},
    {"a kept region",
     [](Scene& s) {
       s.keep = cubesRegion(s.volume->grid().dims, 7, {0.0, 1.0, 0.4});
     }},
    {"looks of labels",
     [](Scene& s) {
       s.keep = withVariedLooks(cubesRegion(s.volume->grid().dims, 9, {1.0, 1.0, 0.6}), s.transferFunction);
     }},
};

/// Steps of 1, 1/2 and 1/4 voxel change by half a level at most how much light dims a head as `draw` draws
/// it. Of each step the picture without is taken off, which has an error of its own. Says what it finds.
inline void expectStepsToChangeNoStrength(const std::function<Image(const Scene&)>& draw,
                                          const std::string& what) {
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced}) {
    Scene scene = shadowedHead(4.0, model);
    scene.quality.preintegrated = Preintegration::automatic;
    std::optional<double> first;
    for (const double step : {1.0, 0.5, 0.25}) {
      scene.quality.stepVoxels = step;
      const double lit = brightness(draw(scene));
      const double dimmedBy = brightness(draw(withoutTravel(scene))) - lit;
      std::cout << nameOf(model) << ", " << what << ", step " << step << ": brightness " << lit
                << ", dimmed by " << dimmedBy << " levels\n";
      EXPECT_GE(dimmedBy, 3.0);
      EXPECT_NEAR(dimmedBy, first.value_or(dimmedBy), 0.5);
      first = first.value_or(dimmedBy);
    }
  }
}

} // namespace limn::test
