// SPDX-License-Identifier: GPL-3.0-or-later
// What light on its way keeps to, drawn by the ray caster: as tests/cpu/CpuLightKeptTest asks of the
// processor.
#include "accuracy/ImageError.h"
#include "cpu/CpuRenderer.h"
#include "cpu/LightFinder.h"
#include "glsl/programs/ShaderVariant.h"
#include "raycaster/RayCaster.h"
#include "scene/light/Shading.h"
#include "support/GlTest.h"
#include "support/TravellingScenes.h"

#include <chrono>
#include <iostream>
#include <optional>
#include <thread>

namespace limn {
namespace {

using test::brightness;
using test::croppedToSkull;
using test::headCutAtTheJaw;
using test::shadowedHead;
using test::skullOverJaw;
using test::withoutTravel;

class CasterLightKept : public test::GlTest {};

Image castIn(Scene scene, LightDetail detail, const glm::ivec2& size) {
  scene.quality.light = detail;
  RayCaster caster;
  return caster.render(scene, size);
}

TEST_F(CasterLightKept, aJawThatIsCroppedAwayDimsNothing) {
  const glm::ivec2 size{72, 80};
  for (const LightDetail detail : {LightDetail::fine, LightDetail::coarse}) {
    const Image expected = castIn(skullOverJaw(false), detail, size);
    Scene sampled = skullOverJaw(false);
    sampled.quality.light = LightDetail::sampled;
    CpuRenderer processor;
    const double ofGrid = imageError(expected, processor.render(sampled, size)).p99_9;
    const ImageError error = imageError(castIn(croppedToSkull(skullOverJaw(true)), detail, size), expected);
    std::cout << "detail " << static_cast<int>(detail) << ": 99.9th percentile " << error.p99_9
              << " levels, of " << ofGrid << " that the grid adds\n";
    EXPECT_LE(error.p99_9, 2.0 * ofGrid); // nodes lie elsewhere: each picture is off by as much
  }
}

TEST_F(CasterLightKept, whatLiesBehindACutFaceMayAsWellBeAir) {
  const glm::ivec2 size{64, 72};
  for (const LightDetail detail : {LightDetail::fine, LightDetail::coarse}) {
    const Image cut = castIn(headCutAtTheJaw(true), detail, size);
    EXPECT_LE(imageError(cut, castIn(headCutAtTheJaw(false), detail, size)).largest, 0.01);
    EXPECT_GE(imageError(cut, castIn(withoutTravel(headCutAtTheJaw(true)), detail, size)).p99_9, 10.0);
  }
}

TEST_F(CasterLightKept, stepsChangeNoStrength) {
  for (const LightDetail detail : {LightDetail::fine, LightDetail::coarse})
    test::expectStepsToChangeNoStrength(
        [detail](const Scene& scene) {
          return castIn(scene, detail, {72, 72});
        },
        "detail " + std::to_string(static_cast<int>(detail)));
}

TEST_F(CasterLightKept, lightOfNoStrengthLeavesNoTrace) {
  const glm::ivec2 size{48, 40};
  RayCaster caster;
  for (const ShadingModel model : localModels)
    for (const Projection projection :
         {Projection::composite, Projection::mip, Projection::average, Projection::xray,
          Projection::isosurface, Projection::compositeIsosurface}) {
      Scene plain = withoutTravel(shadowedHead(6.0, model));
      plain.projection = projection;
      Scene neutral = plain;
      neutral.shading.shadow = {0.0, 30.0};
      neutral.shading.occlusion = {0.0, 50.0};
      const Image expected = caster.render(plain, size);
      const int programs = caster.compiledPrograms();
      const double mb = caster.volumeMb();
      EXPECT_EQ(caster.render(neutral, size), expected);
      EXPECT_EQ(caster.compiledPrograms(), programs);
      EXPECT_EQ(caster.volumeMb(), mb);
      EXPECT_EQ(caster.fragmentShader(neutral), caster.fragmentShader(plain));
      for (const char* word : {"u_directLight", "u_ambientLight", "u_directScale"})
        EXPECT_EQ(caster.fragmentShader(plain).find(word), std::string::npos) << word;
    }
}

TEST_F(CasterLightKept, nodesTakeAnEighthOfTheVoxelsBytesAtMost) {
  for (const double spacing : {3.0, 5.0}) {
    const Scene scene = shadowedHead(spacing);
    RayCaster without, with;
    without.render(withoutTravel(scene), {32, 32});
    with.render(scene, {32, 32});
    const double voxelMb = 2e-6 * static_cast<double>(scene.volume->voxelCount());
    EXPECT_LE(with.volumeMb() - without.volumeMb(), voxelMb / 8.0);
    EXPECT_GT(with.volumeMb(), without.volumeMb());
  }
}

void finish(LightInBackground& light, const Scene& scene) {
  while (light.isFinding(scene))
    std::this_thread::yield();
}

// Whatever was on its way when the box was opened: in the end the light is that of the open box.
TEST_F(CasterLightKept, aCropThatIsOpenedWhileLightIsFoundHasItsOwnLight) {
  Scene scene = shadowedHead(2.0);
  scene.crop = {{0.0, 0.4, 0.0}, {1.0, 1.0, 1.0}};
  LightInBackground light;
  light.known(scene);
  Scene open = scene;
  for (int turn = 1; turn <= 8; ++turn) { // dragged open
    open.crop.lower.y = 0.4 - 0.05 * turn;
    open.quality.light = LightDetail::coarse;
    light.known(open);
    std::this_thread::yield();
  }
  open.quality.light = LightDetail::fine;
  light.known(open);
  finish(light, open);
  const LightVolumes found = light.known(open), expected = LightFinder().find(open);
  EXPECT_EQ(found.directNodes, expected.directNodes);
  EXPECT_TRUE(found.isFine);
  EXPECT_EQ(*found.direct, *expected.direct);
  EXPECT_EQ(*found.ambient, *expected.ambient);
}

// Side by side in one model, which no more than the function tells apart.
struct TwoSides {
  Scene left, right;
};

TwoSides sidesOfOneModel(double spacingMm) {
  TwoSides sides{shadowedHead(spacingMm), {}};
  sides.right = sides.left;
  for (ControlPoint& point : sides.right.transferFunction.points)
    point.opacity *= 0.7;
  return sides;
}

TEST_F(CasterLightKept, bothSidesOfOneModelSeeTheirLightWhileOneIsDragged) {
  TwoSides sides = sidesOfOneModel(3.0);
  sides.left.quality.light = sides.right.quality.light = LightDetail::coarse;
  LightInBackground light;
  // Each turn asks for both, as a view does that draws them in turn.
  int newsOfLeft = 0, newsOfRight = 0;
  LightVolumes left, right;
  const auto begin = std::chrono::steady_clock::now();
  for (int turn = 0; (newsOfLeft < 3 || newsOfRight < 3) &&
                     std::chrono::steady_clock::now() - begin < std::chrono::seconds(60);
       ++turn) {
    sides.left.transferFunction.points.back().opacity = 0.5 + 1e-3 * (turn % 400);
    sides.right.transferFunction.points.back().opacity = 0.4 + 1e-3 * (turn % 300);
    const LightVolumes knownOfLeft = light.known(sides.left), knownOfRight = light.known(sides.right);
    newsOfLeft += knownOfLeft.direct != left.direct ? 1 : 0;
    newsOfRight += knownOfRight.direct != right.direct ? 1 : 0;
    left = knownOfLeft;
    right = knownOfRight;
    std::this_thread::yield();
  }
  EXPECT_GE(newsOfLeft, 3);
  EXPECT_GE(newsOfRight, 3);
}

TEST_F(CasterLightKept, untilItsOwnIsThereASideHasTheLightNearestToIt) {
  TwoSides sides = sidesOfOneModel(5.0);
  LightInBackground light;
  light.known(sides.left);
  light.known(sides.right);
  finish(light, sides.left);
  finish(light, sides.right);
  const LightVolumes left = light.known(sides.left), right = light.known(sides.right);
  EXPECT_NE(*left.ambient, *right.ambient);
  sides.left.transferFunction.points.back().opacity *= 0.99; // right was found and asked for last
  EXPECT_EQ(light.known(sides.left), left);
}

// What finds the fine light of one side for seconds must not keep a hand at the other waiting.
TEST_F(CasterLightKept, fineLightGivesWayToCoarseLightOfTheOtherSide) {
  TwoSides sides = sidesOfOneModel(1.5);
  LightInBackground light;
  while (!light.known(sides.left).areKnown()) // coarse light first
    std::this_thread::yield();
  ASSERT_TRUE(light.isFinding(sides.left));
  sides.right.quality.light = LightDetail::coarse;
  light.known(sides.right);
  while (light.isFinding(sides.right))
    std::this_thread::yield();
  EXPECT_FALSE(light.known(sides.left).isFine);
  finish(light, sides.left); // begins anew, and ends
  EXPECT_TRUE(light.known(sides.left).isFine);
}

} // namespace
} // namespace limn
