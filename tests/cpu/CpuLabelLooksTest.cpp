// SPDX-License-Identifier: GPL-3.0-or-later
// Looks of labels drawn by the CPU engine (DEFINITION section 10): as the reference draws them, and without a
// trace where there are none.
#include "accuracy/ImageError.h"
#include "cpu/CpuRenderer.h"
#include "cpu/bricks/BrickRenderer.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/LabelLooks.h"
#include "scene/ProjectionFacts.h"
#include "scene/light/Shading.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/JudgedTime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 looksPicture{96, 80};

// Cubes of as many labels beside the first, each with a look.
Scene cubesOfLooks(ShadingModel model, int looks, Camera::Projection projection) {
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

void expectAsTheReference(const Scene& scene, const std::string& what) {
  CpuRenderer renderer;
  const ImageError error =
      imageError(renderer.render(scene, looksPicture), toImage(renderReference(scene, looksPicture)));
  std::cout << what << ": 99.9th percentile " << error.p99_9 << ", mean " << error.mean << " levels\n";
  EXPECT_LE(error.p99_9, 1.0) << what;
  EXPECT_LE(error.mean, 0.01) << what; // the engine's bound without looks
}

// Eight labels with looks in cubes of 32 voxels; each shows as much as the scene's own curve, in other
// colours, so that all rays take the samples that they take without.
Scene sceneToTime() {
  Scene scene = headScene(phantomVolume({.spacingMm = 1.5}), ShadingModel::classic);
  scene.camera = orbited(scene.camera, 0.5, 0.3);
  scene.keep = cubesRegion(scene.volume->grid().dims, 32, std::vector<double>(9, 1.0));
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.stepVoxels = 0.5;
  return scene;
}

Scene withEightLooks(Scene scene) {
  std::map<std::size_t, TransferFunction> looks;
  for (std::size_t place = 1; place <= 8; ++place) {
    looks[place] = scene.transferFunction;
    for (ControlPoint& point : looks[place].points)
      point.color = glm::dvec3(point.color.b, point.color.r, 0.1 * static_cast<double>(place));
  }
  scene.keep = withLooks(scene.keep, looks);
  return scene;
}

double medianLookMs(std::vector<double> times) {
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  return times[times.size() / 2];
}

template <class Draw>
double lookMsOf(const Draw& draw) {
  const auto begin = std::chrono::steady_clock::now();
  draw();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

TEST(CpuLooks, eightOfThemTakeLittleMoreTimeThanNone) {
  const Scene plain = sceneToTime();
  const Scene looks = withEightLooks(plain);
  for (const auto tolerance : {std::optional<double>(), std::optional<double>(1.0)}) {
    Scene without = plain, with = looks;
    without.quality.toleranceLevels = with.quality.toleranceLevels = tolerance;
    CpuRenderer one, other;
    std::vector<double> msWithout, msWith;
    one.render(without, {256, 256});
    other.render(with, {256, 256});
    for (int run = 0; run < 5; ++run) { // in turns: a machine that slows slows both
      msWithout.push_back(lookMsOf([&] { one.render(without, {256, 256}); }));
      msWith.push_back(lookMsOf([&] { other.render(with, {256, 256}); }));
    }
    test::judgeMs(tolerance ? "8 looks, cell by cell" : "8 looks, equal steps", medianLookMs(msWith),
                  1.6 * medianLookMs(msWithout));
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

TEST(CpuLooks, whatElseAPictureMayHaveAgreesWithTheReference) {
  for (const Projection projection :
       {Projection::composite, Projection::xray, Projection::compositeIsosurface, Projection::mip}) {
    Scene scene = cubesOfLooks(ShadingModel::robust, 8, Camera::Projection::perspective);
    scene.projection = projection;
    scene.crop = {{0.1, 0.2, 0.0}, {0.9, 1.0, 0.8}};
    scene.fog = distanceFog(200.0, 900.0);
    scene.gradientOpacity = GradientOpacity{{{0.0, 0.2}, {60.0, 1.0}}};
    scene.shading.opacityRange = {0.0, 3.0};
    expectAsTheReference(scene, std::string("fog, crop, gradient opacity, ") + nameOf(projection));
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
    const ImageError error =
        imageError(renderer.render(scene, looksPicture), renderer.render(one, looksPicture));
    EXPECT_LE(error.largest, 0.05);
  }
}

TEST(CpuLooks, emptySpaceAndBricksChangeNoBitAndAlmostNone) {
  for (const double low : {1.0, 0.0}) { // with and without a gradient that decides what absorbs
    Scene scene = cubesOfLooks(ShadingModel::enhanced, 8, Camera::Projection::perspective);
    scene.shading.opacityRange = {low, 1.0};
    for (const auto tolerance : {std::optional<double>(), std::optional<double>(1.0)}) {
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
  for (const Scene& each : scenes) {
    CpuRenderer fresh;
    EXPECT_EQ(used.render(each, looksPicture).pixels, fresh.render(each, looksPicture).pixels);
  }
}

} // namespace
} // namespace limn
