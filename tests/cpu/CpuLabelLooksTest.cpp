// SPDX-License-Identifier: GPL-3.0-or-later
// Looks of labels drawn by the CPU engine (DEFINITION section 10): as the reference draws them, and without a
// trace where there are none.
#include "accuracy/ImageError.h"
#include "cpu/CpuRenderer.h"
#include "cpu/bricks/BrickRenderer.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/ProjectionFacts.h"
#include "scene/light/Shading.h"
#include "support/JudgedTime.h"
#include "support/LookScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

namespace limn {
namespace {

using test::cubesOfLooks;
using test::depthOfFourSteps;
using test::exactRamp;
using test::lookMsOf;
using test::medianLookMs;
using test::rampOfFourSteps;
using test::rampOfTwoLooks;
using test::sceneToTime;
using test::withEightLooks;

constexpr glm::ivec2 looksPicture{96, 80};

void expectAsTheReference(const Scene& scene, const std::string& what) {
  CpuRenderer renderer;
  const ImageError error =
      imageError(renderer.render(scene, looksPicture), toImage(renderReference(scene, looksPicture)));
  std::cout << what << ": 99.9th percentile " << error.p99_9 << ", mean " << error.mean << " levels\n";
  EXPECT_LE(error.p99_9, 1.0) << what;
  EXPECT_LE(error.mean, 0.01) << what; // the engine's bound without looks
}

TEST(CpuLooks, eightOfThemTakeLittleMoreTimeThanNone) {
  const glm::ivec2 size(test::isTimeJudged() ? 256 : 64);
  const int runs = test::isTimeJudged() ? 5 : 1;
  const Scene plain = sceneToTime();
  const Scene looks = withEightLooks(plain);
  struct Way {
    const char* name;
    Preintegration choice;
    std::optional<double> tolerance;
  };
  for (const Way& way : {Way{"8 looks, equal steps", Preintegration::never, {}},
                         {"8 looks, pre-integrated steps", Preintegration::always, {}},
                         {"8 looks, cell by cell", Preintegration::never, 1.0}}) {
    Scene without = plain, with = looks;
    without.quality.preintegrated = with.quality.preintegrated = way.choice;
    without.quality.toleranceLevels = with.quality.toleranceLevels = way.tolerance;
    CpuRenderer one, other;
    std::vector<double> msWithout, msWith;
    one.render(without, size);
    other.render(with, size);
    for (int run = 0; run < runs; ++run) { // in turns: a machine that slows slows both
      msWithout.push_back(lookMsOf([&] { one.render(without, size); }));
      msWith.push_back(lookMsOf([&] { other.render(with, size); }));
    }
    test::judgeMs(way.name, medianLookMs(msWith), 1.6 * medianLookMs(msWithout));
  }
}

TEST(CpuLooks, allModelsAndCamerasAgreeWithTheReference) {
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust})
    for (const auto projection : {Camera::Projection::perspective, Camera::Projection::orthographic})
      for (const int looks : {2, 8}) {
        Scene scene = cubesOfLooks(model, looks, projection);
        expectAsTheReference(scene, std::string(nameOf(model)) + ", " + std::to_string(looks) + " looks");
        scene.quality.toleranceLevels = 1.0;
        scene.quality.fineness = 4.75;
        expectAsTheReference(scene, std::string(nameOf(model)) + ", cell by cell");
      }
}

TEST(CpuLooks, preintegratedStepsAgreeWithTheReference) {
  for (const ShadingModel model : {ShadingModel::none, ShadingModel::classic, ShadingModel::robust})
    for (const double step : {0.5, 2.0})
      for (const Projection projection : {Projection::composite, Projection::xray}) {
        Scene scene = cubesOfLooks(model, 8, Camera::Projection::perspective);
        scene.projection = projection;
        scene.quality.preintegrated = Preintegration::always;
        scene.quality.stepVoxels = step;
        expectAsTheReference(scene, std::string(nameOf(model)) + ", " + nameOf(projection) +
                                        ", pre-integrated, step " + std::to_string(step));
      }
}

TEST(CpuLooks, aStepIsPreintegratedWithinOneLook) {
  CpuRenderer renderer;
  for (const double weight : {1.0, 0.5})
    for (const double factor : {1.0, 0.7})
      for (const Projection projection : {Projection::composite, Projection::xray}) {
        Scene scene = rampOfFourSteps(weight);
        scene.projection = projection;
        scene.shading.model = ShadingModel::enhanced;
        scene.shading.opacityRange = {factor, factor};
        const double counts = projection == Projection::xray ? 1.0 : factor;
        // A few roundings of a float.
        EXPECT_NEAR(renderer.render(scene, {1, 1}).pixels[0].a,
                    -std::expm1(-depthOfFourSteps(weight, counts)), 2e-6);
      }
}

TEST(CpuLooks, coarseStepsWithinOneLookLeaveNoBands) {
  const Image exact = exactRamp(looksPicture);
  Scene scene = rampOfTwoLooks();
  CpuRenderer renderer;
  scene.quality.preintegrated = Preintegration::never;
  const double sampled = imageError(renderer.render(scene, looksPicture), exact).largest;
  scene.quality.preintegrated = Preintegration::always;
  const double integrated = imageError(renderer.render(scene, looksPicture), exact).largest;
  std::cout << "largest of a step of 4 voxels: " << sampled << " levels by samples, " << integrated
            << " pre-integrated\n";
  EXPECT_GT(sampled, 50.0 * integrated);
  EXPECT_LE(integrated, 0.5); // not to be seen
}

TEST(CpuLooks, whatElseAPictureMayHaveAgreesWithTheReference) {
  for (const Projection projection :
       {Projection::composite, Projection::xray, Projection::compositeIsosurface, Projection::mip}) {
    Scene scene = cubesOfLooks(ShadingModel::robust, 8, Camera::Projection::perspective);
    scene.projection = projection;
    scene.crop = {{0.1, 0.2, 0.0}, {0.9, 1.0, 0.8}};
    scene.fog = distanceFog(200.0, 900.0);
    scene.gradientOpacity = GradientOpacity{{{0.0, 0.2}, {60.0, 1.0}}};
    scene.shading.opacityRange = {0.0, 3.0};
    for (const Preintegration choice : {Preintegration::always, Preintegration::never}) {
      scene.quality.preintegrated = choice;
      expectAsTheReference(scene, std::string("fog, crop, gradient opacity, ") + nameOf(projection));
    }
    scene.quality.toleranceLevels = 1.0;
    scene.quality.fineness = 4.75;
    expectAsTheReference(scene, std::string("the same cell by cell, ") + nameOf(projection));
  }
}

TEST(CpuLooks, equalLooksInAllLabelsAreOneLook) {
  for (const auto tolerance : {std::optional<double>(), std::optional<double>(1.0)}) {
    Scene scene = cubesOfLooks(ShadingModel::robust, 2, Camera::Projection::perspective);
    scene.quality.toleranceLevels = tolerance;
    const TransferFunction look = shifted(scene.transferFunction, 40.0);
    scene.keep = withLooks(scene.keep, {{0, look}, {1, look}, {2, look}});
    ASSERT_TRUE(hasLabelLooks(scene));
    Scene one = scene;
    one.keep = withLooks(scene.keep, {});
    one.transferFunction = look;
    CpuRenderer renderer;
    for (const Preintegration choice : {Preintegration::never, Preintegration::always}) {
      one.quality.preintegrated = scene.quality.preintegrated = choice;
      const ImageError error =
          imageError(renderer.render(scene, looksPicture), renderer.render(one, looksPicture));
      EXPECT_LE(error.largest, 0.05);
    }
  }
}

TEST(CpuLooks, emptySpaceAndBricksChangeNoBitAndAlmostNone) {
  for (const double low : {1.0, 0.0}) { // with and without a gradient that decides what absorbs
    Scene scene = cubesOfLooks(ShadingModel::enhanced, 8, Camera::Projection::perspective);
    scene.shading.opacityRange = {low, 1.0};
    for (const auto& [choice, tolerance] : {std::pair(Preintegration::never, std::optional<double>()),
                                            {Preintegration::always, std::optional<double>()},
                                            {Preintegration::never, std::optional<double>(1.0)}}) {
      scene.quality.preintegrated = choice;
      scene.quality.toleranceLevels = tolerance;
      CpuRenderer skipping, searching(0, CpuRenderer::EmptySpace::sampled);
      const Image skipped = skipping.render(scene, looksPicture);
      EXPECT_EQ(skipped.pixels, searching.render(scene, looksPicture).pixels);
      if (tolerance)
        continue; // which bricks keep anew
      // Only sums differ (renderer/cpu/README.md).
      const ImageError error = imageError(drawInBricks(scene, looksPicture, 5, 0), skipped);
      EXPECT_LE(error.largest, 255.0 * 1e-5);
    }
  }
}

TEST(CpuLooks, aUsedRendererDrawsAsAFreshOneWhateverChanged) {
  CpuRenderer used;
  Scene scene = cubesOfLooks(ShadingModel::classic, 2, Camera::Projection::perspective);
  std::vector<Scene> scenes{scene};
  scene.keep = withLooks(scene.keep, {});
  scenes.push_back(scene);
  scene = cubesOfLooks(ShadingModel::classic, 8, Camera::Projection::perspective);
  scene.volume = scenes.front().volume;
  scenes.push_back(scene);
  scene.keep.weights[1] = 0.0;
  scenes.push_back(scene);
  scene.projection = Projection::mip;
  scenes.push_back(scene);
  scene.projection = Projection::composite;
  scene.transferFunction = shifted(scene.transferFunction, 30.0);
  scenes.push_back(scene);
  scene.quality.toleranceLevels.reset();
  scene.quality.preintegrated = Preintegration::always;
  scene.quality.stepVoxels = 2.0;
  scenes.push_back(scene);
  for (const Scene& each : scenes) {
    CpuRenderer fresh;
    EXPECT_EQ(used.render(each, looksPicture).pixels, fresh.render(each, looksPicture).pixels);
  }
}

} // namespace
} // namespace limn
