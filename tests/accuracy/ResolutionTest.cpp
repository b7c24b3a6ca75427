// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/ErrorEstimate.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

// Voxels of 1 mm with values 0..1000; where nothing else is said, the value changes by 100 a mm.
Scene sceneOf(TransferFunction function) {
  Grid grid;
  grid.dims = {11, 2, 2};
  std::vector<std::int16_t> voxels;
  for (int i = 0; i < 44; ++i)
    voxels.push_back(static_cast<std::int16_t>(100 * (i % 11)));
  Scene scene;
  scene.volume =
      std::make_shared<const Volume>(grid, std::move(voxels), Rescale{}, std::nullopt, VolumeInfo{});
  scene.transferFunction = std::move(function);
  return scene;
}

constexpr double perMm = 100.0;

// A peak of opacity whose width at half its height is `width`.
TransferFunction peakOf(double width, double opacity, double at = 500.0) {
  const glm::dvec3 white(1.0);
  return {1.0, {{at - width, white, 0.0}, {at, white, opacity}, {at + width, white, 0.0}}};
}

bool sees(Scene scene, double step, bool isPreintegrated = false) {
  scene.quality.stepVoxels = step;
  return stepSeesFunction(scene, perMm, isPreintegrated);
}

TEST(Resolution, needsStepsThatChangeTheValueByNoMoreThanABandIsWide) {
  const Scene scene = sceneOf(peakOf(20.0, 0.5));
  EXPECT_FALSE(sees(scene, 0.5)); // 50 in a step
  EXPECT_FALSE(sees(scene, 0.25));
  EXPECT_TRUE(sees(scene, 0.125)); // 12.5
}

TEST(Resolution, isGivenByPreintegratedSteps) {
  EXPECT_TRUE(sees(sceneOf(peakOf(20.0, 0.5)), 0.5, true));
}

TEST(Resolution, seesBandsOfColourUnderOneOpacity) {
  TransferFunction stripe = peakOf(20.0, 0.5);
  for (ControlPoint& point : stripe.points)
    point.opacity = 0.5;
  EXPECT_TRUE(sees(sceneOf(stripe), 0.5)) << "white all over";
  stripe.points[1].color = {1.0, 0.0, 0.0};
  EXPECT_FALSE(sees(sceneOf(stripe), 0.5));
}

TEST(Resolution, countsNeitherFaintBandsNorThoseThatNoVoxelReaches) {
  EXPECT_TRUE(sees(sceneOf(peakOf(20.0, 0.05)), 0.5));
  EXPECT_TRUE(sees(sceneOf(peakOf(20.0, 0.5, 1100.0)), 0.5));
}

TEST(Resolution, isGivenByEdgesThatAreNoBands) {
  const glm::dvec3 white(1.0);
  EXPECT_TRUE(sees(sceneOf({1.0, {{499.0, white, 0.0}, {501.0, white, 0.9}}}), 1.0));
}

TEST(Resolution, asksNothingOfProjectionsThatClassifyNoSamples) {
  Scene scene = sceneOf(peakOf(20.0, 0.5));
  for (const Projection projection :
       {Projection::mip, Projection::minip, Projection::average, Projection::isosurface}) {
    scene.projection = projection;
    EXPECT_TRUE(sees(scene, 1.0));
  }
  scene.projection = Projection::xray;
  EXPECT_FALSE(sees(scene, 1.0));
}

} // namespace
} // namespace limn
