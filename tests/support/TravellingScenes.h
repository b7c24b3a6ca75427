// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

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

} // namespace limn::test
