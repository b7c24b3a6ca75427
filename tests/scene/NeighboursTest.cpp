// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/PhantomScene.h"
#include "scene/effects/EffectPlan.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limn {
namespace {

struct Move {
  const char* what;
  void (*choose)(Scene&); ///< the choices, with the slider at its neutral value
  void (*drag)(Scene&);   ///< the slider off it
};

// One row per slider with a neutral value, under choices that matter only off it.
const Move moves[] = {
    {"highlights after Phong in the light's colour",
     [](Scene& s) {
       s.shading.specular = 0.0;
       s.shading.reflection = Reflection::phong;
       s.shading.specularColor = SpecularColor::light;
     },
     [](Scene& s) { s.shading.specular = 0.7; }},
    {"two-sided light from its own direction",
     [](Scene& s) {
       s.shading.diffuse = s.shading.specular = 0.0;
       s.shading.twoSided = true;
       s.shading.lightDirection = glm::dvec3(1.0, 0.0, 0.0);
     },
     [](Scene& s) { s.shading.diffuse = 0.5; }},
    {"light", [](Scene& s) { s.shading.lightIntensity = 0.0; },
     [](Scene& s) { s.shading.lightIntensity = 0.9; }},
    {"sharpness under a logarithm",
     [](Scene& s) {
       s.shading.model = ShadingModel::enhanced;
       s.shading.exponentRange = {32.0, 32.0};
       s.shading.opacityRange = {1.0, 1.0};
       s.shading.gradientCurve = {GradientCurve::Type::log, 10.0};
     },
     [](Scene& s) {
       s.shading.exponentRange = {20.0, 32.0};
     }},
    {"sharpness of the robust model",
     [](Scene& s) {
       s.shading.model = ShadingModel::robust;
       s.shading.exponentRange = {32.0, 32.0};
     },
     [](Scene& s) {
       s.shading.exponentRange = {1.0, 32.0};
     }},
    {"boundary emphasis",
     [](Scene& s) {
       s.shading.model = ShadingModel::enhanced;
       s.shading.opacityRange = {1.0, 1.0};
     },
     [](Scene& s) {
       s.shading.opacityRange = {0.5, 1.0};
     }},
    {"gamma away from 1",
     [](Scene& s) {
       s.shading.model = ShadingModel::enhanced;
       s.shading.gradientCurve = {GradientCurve::Type::gamma, 1.0};
     },
     [](Scene& s) { s.shading.gradientCurve.parameter = 0.4; }},
    {"gamma at 1",
     [](Scene& s) {
       s.shading.model = ShadingModel::enhanced;
       s.shading.gradientCurve = {GradientCurve::Type::gamma, 0.4};
     },
     [](Scene& s) { s.shading.gradientCurve.parameter = 1.0; }},
    {"knee",
     [](Scene& s) {
       s.shading.model = ShadingModel::robust;
       s.shading.specular = 0.1;
       s.shading.diffuse = 0.1;
     },
     [](Scene& s) { s.shading.specular = 3.0; }},
    {"squared fog",
     [](Scene& s) {
       s.fog = {Fog::Mode::exp2, glm::dvec3(0.0), 0.0, 0.0, 0.0};
     },
     [](Scene& s) { s.fog.densityPerMm = 0.002; }},
    {"linear fog from behind",
     [](Scene& s) {
       s.fog = {Fog::Mode::linear, glm::dvec3(0.0), 0.0, 1e5, 2e5};
     },
     [](Scene& s) { s.fog.startMm = 300.0; }},
    {"crop", [](Scene&) {}, [](Scene& s) { s.crop.upper.x = 0.5; }},
    {"a step too long for the curve", [](Scene& s) { s.quality.stepVoxels = 0.1; },
     [](Scene& s) { s.quality.stepVoxels = 4.0; }},
    {"rays that may end", [](Scene& s) { s.quality.earlyTermination = 1.0; },
     [](Scene& s) { s.quality.earlyTermination = 0.98; }},
    {"classic becomes enhanced", [](Scene& s) { s.shading.exponent = 20.0; },
     [](Scene& s) {
       s.shading.model = ShadingModel::enhanced;
       s.shading.gradientCurve = {};
     }},
};

TEST(Neighbours, haveAProgramForEverySliderOffItsNeutralValue) {
  const SceneFacts facts{.canSkipEmptySpace = true, .steepestPerMm = 500.0};
  for (const Move& move : moves) {
    SCOPED_TRACE(move.what);
    Scene scene = test::roughPhantomScene();
    move.choose(scene);
    std::vector<EffectSet> programs{requiredEffects(scene, facts).effects};
    for (const Scene& neighbour : neighbours(scene))
      programs.push_back(withAllNeutral(requiredEffects(neighbour, facts).effects));
    // Both ends of the drag.
    for (const bool isDragged : {false, true}) {
      if (isDragged)
        move.drag(scene);
      const EffectSet needed = requiredEffects(scene, facts).effects;
      EXPECT_TRUE(std::any_of(programs.begin(), programs.end(), [&](EffectSet program) {
        return canStandIn(program, needed);
      })) << isDragged;
    }
  }
}

TEST(Neighbours, areFew) {
  Scene scene = test::roughPhantomScene();
  EXPECT_EQ(neighbours(scene).size(), 2u);
  scene.quality.preintegrated = Preintegration::never;
  EXPECT_EQ(neighbours(scene).size(), 1u);
}

} // namespace
} // namespace limn
