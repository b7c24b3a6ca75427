// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/RayMarcher.h"

#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "support/AnalyticScenes.h"
#include "support/NeedleScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace limn {
namespace {

Scene phantomScene(int fineness) {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 7.0});
  scene.transferFunction = {1.0, {{-200.0, glm::dvec3(0.9, 0.6, 0.5), 0.0}, {300.0, glm::dvec3(1.0), 0.3}}};
  scene.camera = defaultCamera(scene.volume->grid());
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = fineness;
  return scene;
}

ReferencePicture inLocalSteps(const Scene& scene, const glm::ivec2& size, int threads) {
  return renderReference(scene, size, threads, {}, Limiting::clampOrKnee, {}, ToTolerance::byLocalSteps);
}

TEST(BlockWalk, itsChordsFollowOneAnotherFromTheBeginOfASpanToItsEnd) {
  const Scene scene = phantomScene(4);
  const Grid& grid = scene.volume->grid();
  const LocalStepTerms terms = *localStepTerms(scene);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  int rays = 0;
  for (int n = 0; n < 2000; ++n) {
    FramedRay ray;
    ray.eye = -1e4;
    ray.anchor =
        glm::dvec3(grid.dims) * 0.6 * glm::dvec3(anywhere(random), anywhere(random), anywhere(random));
    // Some along axes, some along faces of blocks.
    glm::dvec3 direction(anywhere(random), anywhere(random), anywhere(random));
    for (int axis = 0; axis < 3; ++axis)
      if (n % 7 == axis || n % 11 == axis + 3)
        direction[axis] = 0.0;
    if (glm::length(direction) == 0.0)
      continue;
    ray.direction = glm::normalize(direction) / grid.spacingMm;
    const RaySpan span = spanInBox(ray, croppedBox(grid, scene.crop));
    if (span.isEmpty())
      continue;
    BlockWalk walk(terms, ray, span);
    double at = 0.0;
    int chords = 0;
    while (walk.enterNext()) {
      ASSERT_EQ(walk.entry(), at);
      ASSERT_GT(walk.exit(), at);
      at = walk.exit();
      ASSERT_LT(++chords, 200);
    }
    ASSERT_EQ(at, span.end - span.begin);
    ++rays;
  }
  EXPECT_GT(rays, 500);
}

TEST(LocalMarch, aHomogeneousSlabIsExactWithAnyFineness) {
  // A1: 1 - exp(-κ D), whatever the pieces, because exponents add up.
  for (const int fineness : {0, 3, 9}) {
    Scene scene = test::rayThrough(test::boxOf(glm::dvec3(2.0)));
    scene.transferFunction = test::constantFunction(0.4, glm::dvec3(1.0, 0.5, 0.25));
    scene.quality.toleranceLevels = 1.0;
    scene.quality.fineness = fineness;
    const glm::dvec4 pixel = inLocalSteps(scene, {1, 1}, 1).pixels[0];
    const double alpha = 1.0 - 0.6 * 0.6;
    EXPECT_NEAR(pixel.a, alpha, 1e-12);
    EXPECT_NEAR(pixel.g, 0.5 * alpha, 1e-12);
  }
}

TEST(LocalMarch, anEdgeOfTheFunctionIsFoundToTheFinestStep) {
  // The finest step is 1/2048 voxel of 1 mm and the colour gains 2 per mm.
  Scene scene = test::edgeScene();
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = 8;
  const ReferencePicture picture = inLocalSteps(scene, {1, 1}, 1);
  EXPECT_NEAR(picture.pixels[0].a, 1.0, 1e-6);
  EXPECT_LT(picture.pixels[0].r, 2.0 / 2048.0);
  EXPECT_LT(picture.samples[0], 200) << "an edge is bracketed, not sampled through";
}

TEST(LocalMarch, finerStepsTakeMoreSamplesAndCropAndSurfaceEndThem) {
  int before = 0;
  for (const int fineness : {0, 4, 8}) {
    const ReferencePicture picture = inLocalSteps(phantomScene(fineness), {16, 16}, 2);
    int sum = 0;
    for (const int samples : picture.samples)
      sum += samples;
    EXPECT_GT(sum, before);
    before = sum;
  }
  Scene cropped = phantomScene(8);
  cropped.crop.upper.x = 0.4;
  int sum = 0;
  for (const int samples : inLocalSteps(cropped, {16, 16}, 2).samples)
    sum += samples;
  EXPECT_LT(sum, before);
}

} // namespace
} // namespace limn
