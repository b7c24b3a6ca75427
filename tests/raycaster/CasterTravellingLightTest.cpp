// SPDX-License-Identifier: GPL-3.0-or-later
// Light on its way drawn by the ray caster (DEFINITION section 11): from the nodes that the CPU engine draws
// from, found beside drawing or before it, and without a trace where there is none.
#include "accuracy/ImageError.h"
#include "cpu/CpuRenderer.h"
#include "cpu/LightFinder.h"
#include "engine/VolumeTooLarge.h"
#include "gl/PictureTarget.h"
#include "raycaster/RayCaster.h"
#include "support/GlTest.h"
#include "support/JudgedTime.h"
#include "support/TravellingScenes.h"

#include <chrono>
#include <ctime>
#include <functional>
#include <iostream>
#include <thread>
#include <utility>

namespace limn {
namespace {

using test::shadowedHead;
using test::TravelCase;
using test::travelCases;
using test::withoutTravel;

constexpr glm::ivec2 travellingSize{96, 80};

class CasterTravellingLight : public test::GlTest {};

// Both look the same nodes up; what is left is what both differ by without, and an edge at which a look from
// a sample meets tissue or not.
TEST_F(CasterTravellingLight, everyPictureIsTheProcessors) {
  for (const TravelCase& one : travelCases)
    for (const LightDetail detail : {LightDetail::fine, LightDetail::coarse}) {
      Scene scene = shadowedHead(4.0);
      one.apply(scene);
      scene.quality.light = detail;
      RayCaster caster;
      CpuRenderer processor;
      const Image drawn = caster.render(scene, travellingSize);
      const ImageError error = imageError(drawn, processor.render(scene, travellingSize));
      const double travel = imageError(drawn, caster.render(withoutTravel(scene), travellingSize)).p99_9;
      std::cout << one.what << (detail == LightDetail::fine ? ", fine" : ", coarse") << ": 99.9th percentile "
                << error.p99_9 << ", mean " << error.mean << " levels, of " << travel
                << " that light on its way makes\n";
      EXPECT_LE(error.p99_9, 1.0) << one.what;
      EXPECT_LE(error.mean, 0.1) << one.what;
      EXPECT_GE(travel, 2.5) << one.what << " shows nothing of it";
    }
}

TEST_F(CasterTravellingLight, changesNoBitAndCompilesNothingWhereItIsNeutral) {
  Scene plain = withoutTravel(shadowedHead(5.0));
  plain.shading.lightDirection.reset();
  Scene headlight = plain;
  headlight.shading.shadow = {1.0, 20.0};
  RayCaster caster;
  const Image expected = caster.render(plain, travellingSize);
  const int programs = caster.compiledPrograms();
  const double mb = caster.volumeMb();
  EXPECT_EQ(caster.render(headlight, travellingSize), expected);
  EXPECT_EQ(caster.compiledPrograms(), programs);
  EXPECT_EQ(caster.volumeMb(), mb);
}

TEST_F(CasterTravellingLight, leavesAToleranceToTheProcessor) {
  Scene scene = shadowedHead(8.0);
  scene.quality.toleranceLevels = 1.0;
  RayCaster caster;
  EXPECT_THROW(caster.render(scene, travellingSize), BeyondDriver);
  EXPECT_NO_THROW(caster.render(withoutTravel(scene), travellingSize));
}

// Waits for the light of a scene as a view does, between its turns.
void waitForLight(LightInBackground& light, const Scene& scene) {
  while (light.isFinding(scene))
    std::this_thread::yield();
}

TEST_F(CasterTravellingLight, oldLightServesUntilTheNewIsThere) {
  Scene scene = shadowedHead(3.0);
  LightInBackground light;
  EXPECT_EQ(light.known(scene), LightVolumes{}); // all light comes
  waitForLight(light, scene);
  const LightVolumes first = light.known(scene);
  const LightVolumes expected = LightFinder().find(scene);
  ASSERT_TRUE(first.direct && first.ambient);
  EXPECT_EQ(first.directNodes, expected.directNodes);
  EXPECT_EQ(first.ambientNodes, expected.ambientNodes);
  EXPECT_EQ(*first.direct, *expected.direct);
  EXPECT_EQ(*first.ambient, *expected.ambient);

  Scene edited = scene;
  edited.transferFunction.points.back().opacity *= 0.5;
  EXPECT_EQ(light.known(edited), first);
  EXPECT_TRUE(light.isFinding(edited));
  waitForLight(light, edited);
  const LightVolumes second = light.known(edited);
  EXPECT_NE(second.direct, first.direct);
  EXPECT_EQ(light.known(scene), first); // side by side neither is found twice
  EXPECT_FALSE(light.isFinding(scene));
}

TEST_F(CasterTravellingLight, aDragFasterThanTheLightSeesLight) {
  Scene scene = shadowedHead(2.0);
  scene.quality.light = LightDetail::coarse;
  LightInBackground light;
  light.known(scene);
  int news = 0;
  LightVolumes last;
  const auto begin = std::chrono::steady_clock::now();
  // Each turn of the drag asks for another light at once.
  for (int turn = 0; news < 3 && std::chrono::steady_clock::now() - begin < std::chrono::seconds(60);
       ++turn) {
    scene.shading.lightDirection = glm::dvec3(0.6, -0.7 + 1e-3 * (turn % 500), 1.0);
    const LightVolumes known = light.known(scene);
    news += known.direct != last.direct ? 1 : 0;
    last = known;
    std::this_thread::yield();
  }
  EXPECT_GE(news, 3);
}

TEST_F(CasterTravellingLight, anotherVolumeHasNoneOfItsLight) {
  const Scene scene = shadowedHead(5.0), other = shadowedHead(6.0);
  LightInBackground light;
  light.known(scene);
  waitForLight(light, scene);
  EXPECT_EQ(light.known(other), LightVolumes{});
  waitForLight(light, other);
  EXPECT_NE(light.known(other), LightVolumes{});
}

// Pictures of what moves look at nodes alone, and have a program that can do no more, from the first: that of
// pictures at rest draws the same, slowly. It is compiled ahead where there is time.
TEST_F(CasterTravellingLight, whatMovesHasAProgramOfItsOwnThatDrawsTheSame) {
  for (const TravelCase& one : travelCases) {
    Scene scene = shadowedHead(4.0);
    one.apply(scene);
    RayCaster caster;
    const Image fine = caster.render(scene, travellingSize);
    Scene moving = scene;
    moving.quality.light = LightDetail::coarse;
    const auto looksAtNodesAlone = [](RayCaster& of, const Scene& drawn) {
      return of.fragmentShader(drawn).find("#define NODES_ALONE") != std::string::npos;
    };
    EXPECT_EQ(caster.compiledPrograms(), 1) << one.what;
    EXPECT_FALSE(looksAtNodesAlone(caster, scene)) << one.what;
    EXPECT_TRUE(looksAtNodesAlone(caster, moving)) << one.what;
    caster.leaveOut(EffectSet()); // nothing, with programs that are compiled for that
    const Image before = caster.render(moving, travellingSize);
    caster.leaveOut({});
    EXPECT_EQ(caster.compiledPrograms(), 1) << one.what;
    const FloatTarget sheet({16, 16});
    caster.warmUp(scene, {16, 16});
    EXPECT_EQ(caster.compiledPrograms(), 2) << one.what;
    const Image after = caster.render(moving, travellingSize);
    EXPECT_EQ(caster.compiledPrograms(), 2) << one.what;
    RayCaster other; // without that time
    other.holdLight(caster.lightOf(moving));
    EXPECT_FALSE(other.facts(moving).isReady) << one.what;
    EXPECT_EQ(other.render(moving, travellingSize), after) << one.what;
    EXPECT_EQ(other.compiledPrograms(), 1) << one.what;
    // Compilers reorder sums: floats, not levels.
    EXPECT_LE(imageError(after, before).largest, 0.01) << one.what;
    EXPECT_EQ(caster.render(scene, travellingSize), fine) << one.what;
  }
}

// Of all threads, a software driver's included.
struct Took {
  double processorMs = 0.0; ///< of all threads
  double clockMs = 0.0;     ///< what counts on a graphics card

  void add(const std::function<void()>& work) {
    const std::clock_t begin = std::clock();
    const auto start = std::chrono::steady_clock::now();
    work();
    clockMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    processorMs += 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  }
};

TEST_F(CasterTravellingLight, aFrameFromNodesCostsLittleMore) {
  const glm::ivec2 size(test::isTimeJudged() ? 512 : 64);
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced}) {
    Scene lit = shadowedHead(test::isTimeJudged() ? 1.0 : 4.0, model);
    lit.quality.light = LightDetail::coarse;
    lit.shading.lightAxes = LightAxes::world; // or light would be found anew for each frame
    Scene plain = withoutTravel(lit);
    RayCaster caster;
    caster.render(plain, size);
    caster.render(lit, size);
    const auto frames = [&](const char* what) {
      Took without, with;
      for (int turn = 0; turn < 3; ++turn) {
        plain.camera = lit.camera = orbited(lit.camera, 0.1, 0.0);
        without.add([&] { caster.render(plain, size); });
        with.add([&] { caster.render(lit, size); });
      }
      std::cout << nameOf(model) << ", " << what << ": " << without.processorMs / 3.0
                << " ms of the processor without, " << with.processorMs / 3.0 << " ms with light on its way, "
                << with.processorMs / without.processorMs << " times; on the clock " << without.clockMs / 3.0
                << " and " << with.clockMs / 3.0 << " ms\n";
      return std::pair(without.processorMs, with.processorMs);
    };
    const auto [plainMs, litMs] = frames("while it moves");
    test::judgeMs("three pictures with light looked up", litMs, 1.5 * plainMs);
    lit.quality.light = LightDetail::fine;
    caster.render(lit, size);
    frames("at rest");
  }
}

} // namespace
} // namespace limn
