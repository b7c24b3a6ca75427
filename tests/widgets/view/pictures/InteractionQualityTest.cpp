// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/InteractionQuality.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

constexpr double pixelCount = 500.0 * 1000.0;

// A renderer whose full picture of 500 000 pixels takes `fullMs`.
double msOf(int level, double fullMs) {
  const QualityLevel quality = InteractionQuality::levelAt(level);
  return fullMs * quality.imageScale * quality.imageScale / std::pow(quality.stepFactor, 0.8);
}

int settledLevel(double fullMs) {
  InteractionQuality quality;
  for (int frame = 0; frame < 10; ++frame) {
    const int level = quality.levelFor(pixelCount);
    quality.measured(level, pixelCount, msOf(level, fullMs));
  }
  return quality.levelFor(pixelCount);
}

TEST(InteractionQuality, levelsRunFromFullToCoarse) {
  EXPECT_EQ(InteractionQuality::levelAt(0), (QualityLevel{1.0, 1.0}));
  for (int level = 1; level < InteractionQuality::levelCount; ++level)
    EXPECT_LT(msOf(level, 1.0), msOf(level - 1, 1.0));
}

TEST(InteractionQuality, startsCoarselyAndMeasures) {
  EXPECT_EQ(InteractionQuality().levelFor(pixelCount), InteractionQuality::levelCount - 1);
}

TEST(InteractionQuality, aFastRendererMovesAtFullQuality) {
  EXPECT_EQ(settledLevel(20.0), 0);
}

TEST(InteractionQuality, aSlowRendererKeepsToTheTarget) {
  for (double fullMs : {60.0, 200.0, 1000.0, 2000.0}) {
    const int level = settledLevel(fullMs);
    EXPECT_GT(level, 0) << fullMs;
    EXPECT_LE(msOf(level, fullMs), InteractionQuality::usualTargetMs) << fullMs;
    // No needless coarseness: the next finer level would not have kept its margin of a quarter.
    EXPECT_GT(msOf(level - 1, fullMs), 0.75 * InteractionQuality::usualTargetMs) << fullMs;
  }
}

TEST(InteractionQuality, doesNotAlternateBetweenTwoLevels) {
  InteractionQuality quality;
  quality.measured(3, pixelCount, msOf(3, 85.0));
  const int first = quality.levelFor(pixelCount);
  quality.measured(first, pixelCount, msOf(first, 88.0));
  quality.measured(first, pixelCount, msOf(first, 85.0));
  EXPECT_EQ(quality.levelFor(pixelCount), first);
}

TEST(InteractionQuality, twiceThePixelsAreExpectedToTakeTwiceTheTime) {
  InteractionQuality quality;
  quality.measured(0, pixelCount, 30.0);
  EXPECT_EQ(quality.levelFor(pixelCount), 0);
  EXPECT_GT(quality.levelFor(2.0 * pixelCount), 0);
}

TEST(InteractionQuality, forgettingStartsCoarselyAgain) {
  InteractionQuality quality;
  quality.measured(0, pixelCount, 1.0);
  quality.forget();
  EXPECT_EQ(quality.levelFor(pixelCount), InteractionQuality::levelCount - 1);
}

TEST(InteractionQuality, onlyTheStepOfTheSceneChanges) {
  Scene scene;
  scene.quality.stepVoxels = 0.5;
  Scene expected = scene;
  expected.quality.stepVoxels = 1.0;
  EXPECT_EQ(withQualityLevel(scene, {0.5, 2.0}), expected);
  EXPECT_EQ(sizeAt({0.125, 4.0}, {3, 801}), glm::ivec2(1, 100));
}

} // namespace
} // namespace limn
