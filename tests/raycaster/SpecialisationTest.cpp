// SPDX-License-Identifier: GPL-3.0-or-later
// Simulating only what a scene calls for loses nothing.
#include "raycaster/RayCaster.h"
#include "scene/volume/Phantom.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/RendererRules.h"

#include "EffectSwitches.h"

#include <iostream>
#include <set>

namespace limn {
namespace {

constexpr glm::ivec2 specialisedSize{48, 48};

Scene robustScene() {
  static const std::shared_ptr<const Volume> volume = phantomVolume({.spacingMm = 6.0});
  Scene scene = test::headScene(volume, ShadingModel::robust);
  scene.quality.stepVoxels = 0.5;
  scene.quality.earlyTermination = 0.95;
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

using Specialisation = test::GlTest;

TEST_F(Specialisation, aSpecialisedPictureEqualsOneWithAllEffectsCompiledIn) {
  RayCaster all(RayCaster::EmptySpace::skipped, RayCaster::Programs::allEffects);
  const auto& switches = test::switches();
  int compared = 0;
  std::set<std::string> shaders;
  // Each switch alone and with two others, so that each meets neighbours of every kind.
  for (std::size_t i = 0; i < switches.size(); ++i)
    for (const std::size_t distance : {std::size_t{0}, std::size_t{5}, std::size_t{12}}) {
      const Variation& second = switches[(i + distance) % switches.size()];
      Scene scene = robustScene();
      switches[i].apply(scene);
      second.apply(scene);
      // A caster of its own, or a program compiled before might stand in.
      RayCaster specialised;
      EXPECT_EQ(specialised.render(scene, specialisedSize), all.render(scene, specialisedSize))
          << switches[i].what << ", " << second.what;
      shaders.insert(specialised.fragmentShader(scene));
      ++compared;
    }
  std::cout << compared << " scenes, " << shaders.size() << " specialised programs against "
            << all.compiledPrograms() << " with all effects\n";
  EXPECT_GT(shaders.size(), 40u);
}

TEST_F(Specialisation, anEffectAtItsNeutralValueDrawsNothing) {
  for (const test::Neutral& neutral : test::neutralValues()) {
    SCOPED_TRACE(neutral.what);
    Scene on = robustScene();
    Scene off = robustScene();
    neutral.setJustOff(on);
    neutral.setNeutral(off);
    // The program that was compiled for the effect goes on drawing without it.
    RayCaster caster;
    caster.render(on, specialisedSize);
    const Image standIn = caster.render(off, specialisedSize);
    EXPECT_EQ(caster.compiledPrograms(), 1) << "no stand-in was used";
    RayCaster fresh;
    EXPECT_EQ(standIn, fresh.render(off, specialisedSize));
    EXPECT_NE(caster.fragmentShader(on), fresh.fragmentShader(off))
        << "the plan does not leave the effect out";
  }
}

TEST_F(Specialisation, anEffectJustOffItsNeutralValueShows) {
  RayCaster caster;
  for (const test::Neutral& neutral : test::neutralValues()) {
    SCOPED_TRACE(neutral.what);
    Scene on = robustScene();
    Scene off = robustScene();
    neutral.setJustOff(on);
    neutral.setNeutral(off);
    EXPECT_NE(caster.plan(on).effects, caster.plan(off).effects);
    EXPECT_GT(
        test::largestDifference(caster.render(on, specialisedSize), caster.render(off, specialisedSize)),
        1e-6);
  }
}

TEST_F(Specialisation, warmingUpLeavesNothingToCompileWhenASliderLeavesItsNeutralValue) {
  RayCaster caster;
  Scene scene = robustScene();
  scene.shading.model = ShadingModel::classic;
  caster.render(scene, specialisedSize);
  int rounds = 0;
  while (caster.warmUp(scene, specialisedSize))
    ASSERT_LT(++rounds, 5);
  const int programs = caster.compiledPrograms();
  for (const double density : {0.0, 0.001, 0.002, 0.0})
    for (const double sharpest : {32.0, 60.0}) {
      scene.shading.model = ShadingModel::enhanced;
      scene.shading.exponentRange = {32.0, sharpest};
      scene.shading.opacityRange = {1.0, 1.0};
      scene.fog = {Fog::Mode::exp, glm::dvec3(0.5), density, 0.0, 0.0};
      const Image image = caster.render(scene, specialisedSize);
      RayCaster fresh;
      EXPECT_EQ(image, fresh.render(scene, specialisedSize)) << density << ", " << sharpest;
    }
  EXPECT_EQ(caster.compiledPrograms(), programs);
}

TEST_F(Specialisation, everyParameterShowsInAUsedCasterAsInAFreshOne) {
  const Scene base = robustScene();
  RayCaster used;
  const Image before = used.render(base, specialisedSize);
  for (const Variation& variation : everyParameter()) {
    SCOPED_TRACE(variation.what);
    Scene scene = base;
    variation.apply(scene);
    const Image shown = used.render(scene, specialisedSize);
    EXPECT_NE(shown, before) << "does not show";
    RayCaster fresh;
    EXPECT_EQ(shown, fresh.render(scene, specialisedSize));
    EXPECT_EQ(used.render(base, specialisedSize), before) << "something of it stays behind";
  }
}

TEST_F(Specialisation, whatCannotBeSeenIsNotDrawnAndNothingIsMeasuredForIt) {
  RayCaster caster;
  Scene scene = robustScene();
  const double beyond = scene.volume->range().highest + 1.0;
  scene.transferFunction.points = {{beyond, glm::dvec3(1.0), 0.0}, {beyond + 1.0, glm::dvec3(1.0), 1.0}};
  EXPECT_EQ(caster.render(scene, specialisedSize), Image(specialisedSize));
  EXPECT_EQ(caster.compiledPrograms(), 0);
  EXPECT_EQ(caster.gradientScale(), GradientScale{});
  scene = robustScene();
  scene.shading.model = ShadingModel::none;
  EXPECT_NE(caster.render(scene, specialisedSize), Image(specialisedSize));
  EXPECT_EQ(caster.gradientScale(), GradientScale{}) << "an unlit picture needs no gradients";
}

} // namespace
} // namespace limn
