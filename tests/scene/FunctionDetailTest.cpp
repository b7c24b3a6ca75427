// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/FunctionDetail.h"

#include "scene/effects/EffectPlan.h"
#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

#include <limits>

namespace limn {
namespace {

constexpr ValueRange everything{-1000.0, 3000.0};
const glm::dvec3 white(1.0);

TransferFunction ramp(double width) {
  return {1.0, {{300.0 - width / 2.0, white, 0.0}, {300.0 + width / 2.0, white, 0.6}}};
}

TransferFunction band(double width) {
  return {1.0, {{300.0 - width / 2.0, white, 0.1}, {300.0, white, 0.5}, {300.0 + width / 2.0, white, 0.0}}};
}

TEST(FunctionDetail, theLargestChangeIsThatOfTheSteepestPlace) {
  EXPECT_NEAR(largestChangeOver(ramp(200.0), 50.0, everything), 0.15, 1e-12);
  EXPECT_NEAR(largestChangeOver(ramp(20.0), 50.0, everything), 0.6, 1e-12);
  EXPECT_NEAR(largestChangeOver(ramp(0.0), 1.0, everything), 0.6, 1e-12) << "a step";
  EXPECT_EQ(largestChangeOver(ramp(0.0), 1.0, {400.0, 500.0}), 0.0) << "outside the data";
  EXPECT_EQ(largestChangeOver({}, 1.0, everything), 0.0);
  // A step of colour at an opacity of a half.
  const TransferFunction colors{1.0, {{0.0, glm::dvec3(0.0), 0.5}, {0.0, glm::dvec3(0.8), 0.5}}};
  EXPECT_NEAR(largestChangeOver(colors, 1.0, everything), 0.4, 1e-12);
}

TEST(FunctionDetail, bandsOfColourShowAsFarAsTheirOpacityLetsThem) {
  // White and opaque by a half, with a red stripe: green and blue fall to 0 and rise again.
  TransferFunction stripe = band(100.0);
  for (ControlPoint& point : stripe.points)
    point.opacity = 0.5;
  stripe.points[1].color = {1.0, 0.0, 0.0};
  EXPECT_EQ(narrowestBand(stripe, 0.1, everything), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(narrowestVisibleBand(stripe, 0.1, everything), 50.0, 1e-9);
  for (ControlPoint& point : stripe.points)
    point.opacity = 0.05;
  EXPECT_EQ(narrowestVisibleBand(stripe, 0.1, everything), std::numeric_limits<double>::infinity());
  EXPECT_EQ(narrowestVisibleBand(band(100.0), 0.1, everything), narrowestBand(band(100.0), 0.1, everything));
}

TEST(FunctionDetail, aBandIsAsWideAsAtHalfItsHeight) {
  // From 0.5 the lower side falls by 0.4: half of it is reached halfway down the left ramp, 0.4/0.5 · ½ of
  // the way down the right one, which falls by 0.5.
  EXPECT_NEAR(narrowestBand(band(100.0), 0.1, everything), 25.0 + 20.0, 1e-9);
  EXPECT_EQ(narrowestBand(band(100.0), 0.45, everything), std::numeric_limits<double>::infinity());
  EXPECT_EQ(narrowestBand(ramp(10.0), 0.1, everything), std::numeric_limits<double>::infinity());
  EXPECT_EQ(narrowestBand({}, 0.1, everything), std::numeric_limits<double>::infinity());
}

TEST(FunctionDetail, aValleyIsABandToo) {
  const TransferFunction valley{
      1.0, {{0.0, white, 0.8}, {100.0, white, 0.2}, {110.0, white, 0.2}, {210.0, white, 0.8}}};
  EXPECT_NEAR(narrowestBand(valley, 0.1, everything), 50.0 + 10.0 + 50.0, 1e-9);
}

TEST(FunctionDetail, opacitiesOverAnotherDistanceAbsorbAsMuch) {
  // 1 - (1 - 0.19)^(1/2) = 0.1, 1 - (1 - 0.1)^2 = 0.19.
  const TransferFunction overTwo{2.0, {{0.0, white, 0.19}, {1.0, white, 0.0}}};
  const TransferFunction overOne = overDistance(overTwo, 1.0);
  EXPECT_EQ(overOne.unitDistanceMm, 1.0);
  EXPECT_NEAR(overOne.points[0].opacity, 0.1, 1e-12);
  EXPECT_EQ(overOne.points[1].opacity, 0.0);
  EXPECT_EQ(overVoxelAtLeast(overTwo, 1.0), overTwo) << "its distance is longer than a voxel";
  EXPECT_NEAR(overVoxelAtLeast(overOne, 2.0).points[0].opacity, 0.19, 1e-12);
}

TEST(EffectPlans, aStepThatMissesABandOrAnEdgeAsksForPreintegration) {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 8.0});
  scene.quality.stepVoxels = 0.125; // a millimetre
  const auto isPreintegrated = [&scene](double steepestPerMm) {
    return requiredEffects(scene, {.steepestPerMm = steepestPerMm}).effects.has(Effect::preintegration);
  };
  // 340 a step, the change of a CT head at half a voxel: see EffectPlan.cpp for the measurement.
  for (const double width : {0.0, 10.0, 25.0, 50.0}) {
    scene.transferFunction = ramp(width);
    EXPECT_TRUE(isPreintegrated(340.0)) << width;
  }
  for (const double width : {200.0, 400.0}) {
    scene.transferFunction = ramp(width);
    EXPECT_FALSE(isPreintegrated(340.0)) << width;
  }
  for (const double width : {20.0, 50.0, 100.0, 200.0}) {
    scene.transferFunction = band(width);
    EXPECT_TRUE(isPreintegrated(340.0)) << width;
  }
  scene.transferFunction = band(600.0);
  EXPECT_FALSE(isPreintegrated(340.0));
  EXPECT_FALSE(isPreintegrated(0.0));
  scene.quality.preintegrated = Preintegration::always;
  EXPECT_TRUE(isPreintegrated(0.0));
  scene.quality.preintegrated = Preintegration::never;
  scene.transferFunction = ramp(0.0);
  EXPECT_FALSE(isPreintegrated(340.0));
}

} // namespace
} // namespace limn
