// SPDX-License-Identifier: GPL-3.0-or-later
// One row per effect: a scene that calls for it, where the shader must agree with the reference, and where
// leaving it out must show.
#include "engine/VolumeTooLarge.h"
#include "raycaster/RayCaster.h"
#include "scene/effects/EffectPlan.h"
#include "scene/steps/RayFrame.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/ImageCompare.h"

namespace limn {
namespace {

constexpr glm::ivec2 effectsSize{80, 96};

struct EffectCase {
  const char* what;
  Effect effect;
  void (*apply)(Scene&);
};

Region cubes(const Scene& scene, const std::vector<double>& weights) {
  return cubesRegion(scene.volume->grid().dims, 7, weights);
}

const EffectCase effectCases[] = {
    {"Phong", Effect::phong, [](Scene& s) { s.shading.reflection = Reflection::phong; }},
    {"Phong under a fixed light, two-sided", Effect::fixedLight,
     [](Scene& s) {
       s.shading.reflection = Reflection::phong;
       s.shading.twoSided = true;
       s.shading.lightDirection = glm::dvec3(1.0, 0.5, -1.0);
     }},
    {"two-sided", Effect::twoSided,
     [](Scene& s) {
       s.shading.twoSided = true;
       s.shading.lightDirection = glm::dvec3(-1.0, -1.0, 0.0);
     }},
    {"fixed light", Effect::fixedLight,
     [](Scene& s) { s.shading.lightDirection = glm::dvec3(0.0, 1.0, -3.0); }},
    {"highlights of the light", Effect::specularOfLight,
     [](Scene& s) { s.shading.specularColor = SpecularColor::light; }},
    {"gamma curve", Effect::gammaCurve,
     [](Scene& s) {
       s.shading.gradientCurve = {GradientCurve::Type::gamma, 0.4};
     }},
    {"log curve", Effect::logCurve,
     [](Scene& s) {
       s.shading.gradientCurve = {GradientCurve::Type::log, 50.0};
     }},
    {"constant opacity coefficient", Effect::opacityFactor,
     [](Scene& s) {
       s.shading.opacityRange = {2.5, 2.5};
     }},
    {"gradient opacity", Effect::gradientOpacity,
     [](Scene& s) {
       s.gradientOpacity = GradientOpacity{{{0.0, 0.0}, {50.0, 0.3}, {50.0, 0.6}, {200.0, 1.0}}};
     }},
    {"knee", Effect::knee,
     [](Scene& s) {
       s.shading.model = ShadingModel::robust;
       s.shading.specular = 3.0;
     }},
    {"energy factor", Effect::energyFactor, [](Scene& s) { s.shading.model = ShadingModel::robust; }},
    {"significance", Effect::significance, [](Scene& s) { s.shading.model = ShadingModel::robust; }},
    {"linear fog", Effect::fogLinear,
     [](Scene& s) {
       s.fog = {Fog::Mode::linear, glm::dvec3(0.4, 0.5, 0.6), 0.0, 500.0, 900.0};
     }},
    {"exponential fog", Effect::fogExp,
     [](Scene& s) {
       s.fog = {Fog::Mode::exp, glm::dvec3(0.4, 0.5, 0.6), 0.002, 300.0, 0.0};
     }},
    {"squared exponential fog", Effect::fogExp2,
     [](Scene& s) {
       s.fog = {Fog::Mode::exp2, glm::dvec3(0.4, 0.5, 0.6), 0.001, 0.0, 0.0};
     }},
    {"cut faces", Effect::cutFaces,
     [](Scene& s) {
       s.crop = {{0.0, 0.3, 0.1}, {0.55, 1.0, 0.8}};
       s.camera = orbited(s.camera, 0.6, 0.4);
     }},
    {"early termination", Effect::earlyTermination, [](Scene& s) { s.quality.earlyTermination = 0.98; }},
    {"single loop for long rays", Effect::longRays,
     [](Scene& s) {
       s.quality.stepVoxels = 0.003;
       s.crop.lower.y = 0.45;
       s.crop.upper.y = 0.5;
     }},
    {"jitter", Effect::jitter, [](Scene& s) { s.quality.jitter = true; }},
    {"pre-integration", Effect::preintegration,
     [](Scene& s) { s.quality.preintegrated = Preintegration::always; }},
    {"pre-integration of steps and a spike", Effect::preintegration,
     [](Scene& s) {
       s.quality.preintegrated = Preintegration::always;
       s.transferFunction = withPointAdded(s.transferFunction, 400.0, 0.2);
       s.transferFunction = withPointAdded(s.transferFunction, 400.0, 0.9);
       s.transferFunction = withPointAdded(s.transferFunction, 402.0, 0.9);
       s.transferFunction = withPointAdded(s.transferFunction, 402.0, 0.1);
     }},
    {"smooth normals", Effect::smoothNormals, [](Scene& s) { s.shading.gradientSmoothing = 6.0; }},
    {"smooth normals of classic light in pre-integrated steps", Effect::smoothNormals,
     [](Scene& s) {
       s.shading.model = ShadingModel::classic;
       s.shading.gradientSmoothing = 4.0;
       s.quality.preintegrated = Preintegration::always;
     }},
    {"gradient opacity of a smoothed field, unlit", Effect::smoothNormals,
     [](Scene& s) {
       s.shading.model = ShadingModel::none;
       s.shading.gradientSmoothing = 5.0;
       s.gradientOpacity = GradientOpacity{{{0.0, 0.0}, {50.0, 0.3}, {50.0, 0.6}, {200.0, 1.0}}};
     }},
    {"smooth normals of an isosurface", Effect::smoothNormals,
     [](Scene& s) {
       s.projection = Projection::isosurface;
       s.shading.gradientSmoothing = 6.0;
     }},
    {"smooth normals by own weights", Effect::smoothNormals,
     [](Scene& s) {
       s.shading.gradientSmoothing = 6.0;
       s.quality.ownWeights = true;
     }},
    {"maximum", Effect::mip, [](Scene& s) { s.projection = Projection::mip; }},
    {"minimum", Effect::minip,
     [](Scene& s) {
       s.projection = Projection::minip;
       s.crop = {{0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}};
       for (ControlPoint& point : s.transferFunction.points)
         point.opacity = 0.1 + 0.8 * point.opacity;
     }},
    {"average", Effect::average,
     [](Scene& s) {
       s.projection = Projection::average;
       for (ControlPoint& point : s.transferFunction.points)
         point.opacity = 0.1 + 0.8 * point.opacity;
     }},
    {"X-ray", Effect::xray, [](Scene& s) { s.projection = Projection::xray; }},
    {"pre-integrated X-ray", Effect::xray,
     [](Scene& s) {
       s.projection = Projection::xray;
       s.quality.preintegrated = Preintegration::always;
     }},
    {"isosurface", Effect::isosurface, [](Scene& s) { s.projection = Projection::isosurface; }},
    {"jittered isosurface in fog", Effect::isosurface,
     [](Scene& s) {
       s.projection = Projection::isosurface;
       s.quality.jitter = true;
       s.fog = {Fog::Mode::exp, glm::dvec3(0.4, 0.5, 0.6), 0.002, 300.0, 0.0};
     }},
    {"composite up to a surface", Effect::hybrid,
     [](Scene& s) { s.projection = Projection::compositeIsosurface; }},
    {"cropped composite up to a surface", Effect::hybrid,
     [](Scene& s) {
       s.projection = Projection::compositeIsosurface;
       s.isovalue = 20.0;
       s.crop = {{0.0, 0.3, 0.1}, {0.55, 1.0, 0.8}};
       s.camera = orbited(s.camera, 0.6, 0.4);
     }},
    {"kept region", Effect::region,
     [](Scene& s) {
       s.keep = cubes(s, {1.0, 0.0, 0.4});
     }},
    {"kept region, unlit, in pre-integrated steps", Effect::region,
     [](Scene& s) {
       s.keep = cubes(s, {1.0, 0.0, 0.4});
       s.shading.model = ShadingModel::none;
       s.quality.preintegrated = Preintegration::always;
     }},
    {"looks of labels", Effect::labelLooks,
     [](Scene& s) {
       s.keep = withVariedLooks(cubes(s, {1.0, 1.0, 1.0}), s.transferFunction);
     }},
    {"looks of labels in a kept region, unlit, with jitter and crowded points", Effect::labelLooks,
     [](Scene& s) {
       s.keep = withVariedLooks(cubes(s, {1.0, 0.0, 0.4, 1.0}), s.transferFunction);
       s.shading.model = ShadingModel::none;
       s.quality.jitter = true;
       for (const double value : {40.0, 40.1, 40.2, 40.3, 40.4, 40.5})
         s.transferFunction = withPointAdded(s.transferFunction, value, value > 40.2 ? 0.3 : 0.05);
     }},
    {"looks of labels in pre-integrated steps", Effect::labelLooks,
     [](Scene& s) {
       s.keep = withVariedLooks(cubes(s, {1.0, 0.0, 0.4, 1.0}), s.transferFunction);
       s.quality.preintegrated = Preintegration::always;
     }},
    {"X-ray of looks of labels in pre-integrated steps", Effect::labelLooks,
     [](Scene& s) {
       s.projection = Projection::xray;
       s.keep = withVariedLooks(cubes(s, {1.0, 0.3, 1.0}), s.transferFunction);
       s.quality.preintegrated = Preintegration::always;
     }},
    {"X-ray of looks of labels", Effect::labelLooks,
     [](Scene& s) {
       s.projection = Projection::xray;
       s.keep = withVariedLooks(cubes(s, {1.0, 0.3, 1.0}), s.transferFunction);
     }},
    {"X-ray of a kept region", Effect::region,
     [](Scene& s) {
       s.keep = cubes(s, {0.0, 0.25});
       s.projection = Projection::xray;
     }},
    {"maximum of a kept region", Effect::region,
     [](Scene& s) {
       s.keep = cubes(s, {0.0, 1.0, 0.4});
       s.projection = Projection::mip;
     }},
    {"minimum of a kept region", Effect::region,
     [](Scene& s) {
       s.keep = cubes(s, {0.0, 1.0, 0.4});
       s.projection = Projection::minip;
       s.crop = {{0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}};
       for (ControlPoint& point : s.transferFunction.points)
         point.opacity = 0.1 + 0.8 * point.opacity;
     }},
    {"average of a kept region", Effect::region,
     [](Scene& s) {
       s.keep = cubes(s, {0.0, 1.0, 0.4});
       s.projection = Projection::average;
       for (ControlPoint& point : s.transferFunction.points)
         point.opacity = 0.1 + 0.8 * point.opacity;
     }},
    {"isosurface of a kept region", Effect::region,
     [](Scene& s) {
       s.keep = cubes(s, {0.0, 1.0, 0.7});
       s.projection = Projection::isosurface;
     }},
    {"composite of a kept region up to a surface", Effect::region,
     [](Scene& s) {
       s.keep = cubes(s, {0.0, 1.0, 0.7});
       s.projection = Projection::compositeIsosurface;
     }},
    {"own weights of a kept region", Effect::ownWeights,
     [](Scene& s) {
       s.keep = cubes(s, {1.0, 0.0, 0.4});
       s.quality.ownWeights = true;
     }},
    {"maximum by own weights", Effect::ownWeights,
     [](Scene& s) {
       s.projection = Projection::mip;
       s.quality.ownWeights = true;
     }},
    {"crowded control points", Effect::denseFunctions,
     [](Scene& s) {
       for (const double value : {40.0, 40.1, 40.2, 40.3, 40.4, 40.5})
         s.transferFunction = withPointAdded(s.transferFunction, value, value > 40.2 ? 0.3 : 0.05);
     }},
};

Scene enhancedScene() {
  static const std::shared_ptr<const Volume> volume = phantomVolume({.spacingMm = 4.0});
  return test::headScene(volume, ShadingModel::enhanced);
}

// Own weights take a driver that weighs in 8 bits, as graphics cards do.
RayCaster casterFor(const EffectCase& row) {
  Decisions decisions;
  if (row.effect == Effect::ownWeights)
    decisions.weights = FilterWeights::eightBits;
  return RayCaster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, decisions);
}

using Effects = test::GlTest;

TEST_F(Effects, everyEffectAgreesWithTheReferenceAndShows) {
  const Scene base = enhancedScene();
  const Image without = RayCaster().render(base, effectsSize);
  RayCaster usual;
  for (const EffectCase& row : effectCases) {
    SCOPED_TRACE(row.what);
    RayCaster own = casterFor(row);
    RayCaster& caster = row.effect == Effect::ownWeights ? own : usual;
    Scene scene = base;
    row.apply(scene);
    const Image image = caster.render(scene, effectsSize);
    EXPECT_NE(image, without) << "the effect does not show";
    const ReferencePicture reference = renderReference(scene, effectsSize);
    const std::vector<int> counts = caster.sampleCounts(scene, effectsSize);
    const test::Difference difference = test::differenceOf(
        image, reference, [&](std::size_t i) { return counts[i] == reference.samples[i]; });
    std::cout << row.what << ": " << difference << "\n";
    // A ray that ends at 0.98 may end a sample earlier or later: up to 0.02 of a level-255 sample.
    EXPECT_LE(difference.largest, row.effect == Effect::earlyTermination ? 5.1 : 0.5);
    EXPECT_LE(difference.mean, 0.01);
    EXPECT_GT(difference.pixels, 300u);
  }
}

TEST_F(Effects, lightOnItsWayShowsAndLeavesNoTraceWhereItIsOff) {
  RayCaster caster;
  Scene scene = enhancedScene();
  scene.shading.lightDirection = glm::dvec3(1.0, 1.0, -1.0);
  const Image plain = caster.render(scene, effectsSize);
  scene.shading.shadow.strength = 0.5;
  EXPECT_NE(caster.render(scene, effectsSize), plain);
  scene.shading.shadow.strength = 0.0;
  scene.shading.occlusion.strength = 0.5;
  EXPECT_NE(caster.render(scene, effectsSize), plain);
  scene.shading.occlusion.strength = 0.0;
  scene.shading.occlusion.reachMm = 5.0;
  EXPECT_EQ(caster.render(scene, effectsSize), plain);
}

TEST_F(Effects, smoothNormalsLeaveNoTraceWhereThereAreNone) {
  RayCaster caster;
  Scene scene = enhancedScene();
  const Image plain = caster.render(scene, effectsSize);
  const double volumeMb = caster.volumeMb();
  scene.shading.gradientSmoothing = 1.3; // 3σ is less than a voxel
  EXPECT_EQ(caster.render(scene, effectsSize), plain);
  EXPECT_EQ(caster.volumeMb(), volumeMb);
  scene.shading.gradientSmoothing = 6.0;
  EXPECT_NE(caster.render(scene, effectsSize), plain);
  EXPECT_NEAR(caster.volumeMb(), 2.0 * volumeMb, 1e-9); // both in floats
  scene.shading.gradientSmoothing = 0.0;
  EXPECT_EQ(caster.render(scene, effectsSize), plain);
  // It stays for pictures that take turns, and goes with its volume.
  EXPECT_NEAR(caster.volumeMb(), 2.0 * volumeMb, 1e-9);
  scene.volume = phantomVolume({.spacingMm = 4.0});
  EXPECT_EQ(caster.render(scene, effectsSize), plain);
  EXPECT_EQ(caster.volumeMb(), volumeMb);
}

TEST_F(Effects, smoothNormalsAreMadeReadyInPiecesThatAddUp) {
  RayCaster caster;
  Scene scene = enhancedScene();
  scene.shading.gradientSmoothing = 6.0;
  double last = 0.0;
  int pieces = 0;
  while (last < 1.0) {
    const double there = caster.makeReady(scene);
    EXPECT_GT(there, last);
    last = there;
    ++pieces;
  }
  EXPECT_GE(pieces, 3); // of the volume, of smoothing, of its texture
  EXPECT_EQ(caster.makeReady(scene), 1.0);
}

TEST_F(Effects, whereTheCardHasNoRoomForASmoothedVolumeItIsRefused) {
  const Scene plain = enhancedScene();
  const double needed =
      1e-6 * 4.0 *
      static_cast<double>((plain.volume->grid().dims.x + 2) * (plain.volume->grid().dims.y + 2) *
                          (plain.volume->grid().dims.z + 2));
  RayCaster caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, {},
                   {1.5 * needed, false});
  Scene smooth = plain;
  smooth.shading.gradientSmoothing = 6.0;
  EXPECT_NO_THROW(caster.render(plain, effectsSize));
  EXPECT_THROW(caster.render(smooth, effectsSize), VolumeTooLarge);
  EXPECT_NO_THROW(caster.render(plain, effectsSize));
}

TEST_F(Effects, physicalLightIsRefusedAndNeverLeftOut) {
  RayCaster caster;
  Scene scene = enhancedScene();
  scene.shading.model = ShadingModel::physical;
  EXPECT_THROW(caster.render(scene, effectsSize), BeyondDriver);
  // MIP shows values, whatever the model.
  scene.projection = Projection::mip;
  const Image mip = caster.render(scene, effectsSize);
  scene.shading.model = ShadingModel::none;
  EXPECT_EQ(caster.render(scene, effectsSize), mip);
}

TEST(EffectPlans, lightOnItsWayIsAskedForWhereItShows) {
  Scene scene = enhancedScene();
  scene.shading.shadow = {0.5, 4.0};
  scene.shading.occlusion = {0.5, 10.0};
  scene.shading.lightDirection.reset();
  EXPECT_FALSE(requiredEffects(scene, {}).effects.has(Effect::shadow)); // a headlight casts none
  EXPECT_TRUE(requiredEffects(scene, {}).effects.has(Effect::occlusion));
  scene.shading.lightDirection = glm::dvec3(1.0, 0.0, 0.0);
  EXPECT_TRUE(requiredEffects(scene, {}).effects.has(Effect::shadow));
  scene.shading.ambient = 0.0;
  EXPECT_FALSE(requiredEffects(scene, {}).effects.has(Effect::occlusion));
  scene.shading.lightIntensity = 0.0;
  EXPECT_FALSE(requiredEffects(scene, {}).effects.hasAny(travellingLight));
}

TEST(EffectPlans, everyRowsSceneCallsForItsEffect) {
  for (const EffectCase& row : effectCases) {
    Scene scene = enhancedScene();
    row.apply(scene);
    const bool isDense = row.effect == Effect::denseFunctions;
    const EffectPlan plan =
        requiredEffects(scene, {.canSkipEmptySpace = true, .hasDenseFunctions = isDense, .filterBits = 8});
    EXPECT_TRUE(plan.effects.has(row.effect)) << row.what;
    EXPECT_EQ(plan.effects, canonical(plan.effects)) << row.what;
    ASSERT_EQ(plan.reasons.size(), static_cast<std::size_t>(effectCount));
    for (const EffectReason& reason : plan.reasons) {
      EXPECT_EQ(reason.isNeeded, plan.effects.has(reason.effect));
      EXPECT_FALSE(reason.reason.empty() && reason.isNeeded);
    }
  }
}

TEST(EffectPlans, anUnlitPictureNeedsNothing) {
  Scene scene = enhancedScene();
  scene.shading.model = ShadingModel::none;
  EXPECT_EQ(requiredEffects(scene, {}).effects.without(Effect::earlyTermination), EffectSet());
}

TEST(EffectPlans, neutralValuesAskForNothing) {
  Scene scene = enhancedScene();
  scene.shading.model = ShadingModel::classic;
  const EffectSet classic = requiredEffects(scene, {}).effects;
  Scene neutral = scene;
  neutral.shading.model = ShadingModel::robust;
  neutral.shading.exponentRange = {scene.shading.exponent, scene.shading.exponent};
  neutral.shading.opacityRange = {1.0, 1.0};
  neutral.shading.significance.reset();
  neutral.shading.knee = 1.0 + 0.75; // the sum of the terms reaches 0.25 + 0.75 + 0.75
  neutral.shading.gradientCurve = {GradientCurve::Type::gamma, 1.0};
  neutral.fog.mode = Fog::Mode::exp;
  EXPECT_EQ(requiredEffects(neutral, {}).effects, classic);
  neutral.shading.exponentRange.atBoundary += 1e-3;
  EXPECT_NE(requiredEffects(neutral, {}).effects, classic);
}

} // namespace
} // namespace limn
