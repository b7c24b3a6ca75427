// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/LocalSteps.h"

#include "scene/steps/BlockSteps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace limn {
namespace {

// Voxels of 0.5 x 1 x 1 mm with values of their index.
Volume volumeOf(const glm::ivec3& dims, const std::function<double(const glm::ivec3&)>& value) {
  std::vector<double> voxels;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        voxels.push_back(value({i, j, k}));
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {0.5, 1.0, 1.0};
  return Volume(grid, std::move(voxels), {}, std::nullopt, {});
}

TransferFunction peak(double at, double width) {
  TransferFunction function;
  for (const double x : {-1.0, -0.5, 0.5, 1.0})
    function.points.push_back({at + x * width, glm::dvec3(1.0), std::abs(x) < 0.75 ? 0.5 : 0.0});
  return function;
}

TEST(LocalSteps, stepsAreHalvedEverySecondRung) {
  EXPECT_DOUBLE_EQ(stepOfRung(0), 2.0);
  EXPECT_DOUBLE_EQ(stepOfRung(1), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(stepOfRung(2), 1.0);
  EXPECT_DOUBLE_EQ(stepOfRung(finestRung), 1.0 / 2048.0);
}

TEST(LocalSteps, aChordIsCutIntoStepsAndNoRemainderShorterThanHalfOfOne) {
  EXPECT_EQ(pieceOf(10.0, 1.0), 1.0);
  EXPECT_EQ(pieceOf(1.5, 1.0), 1.0);
  EXPECT_EQ(pieceOf(1.4, 1.0), 0.7);
  EXPECT_EQ(pieceOf(1.0, 1.0), 1.0);
  EXPECT_EQ(pieceOf(0.3, 1.0), 0.3);
}

TEST(LocalSteps, aStepIsTakenAgainAboveTheLimitAndRelaxedFarBelowIt) {
  EXPECT_TRUE(isToBeRefined(1.1, 1.0, 4));
  EXPECT_FALSE(isToBeRefined(1.0, 1.0, 4));
  EXPECT_FALSE(isToBeRefined(1.1, 1.0, finestRung));
  EXPECT_EQ(refinedRung(4, 1.1, 1.0), 6);
  EXPECT_EQ(refinedRung(4, 9.0, 1.0), 8);
  EXPECT_EQ(refinedRung(finestRung - 1, 9.0, 1.0), finestRung);
  EXPECT_EQ(relaxedRung(6, 2, 0.2, 1.0), 4);
  EXPECT_EQ(relaxedRung(6, 5, 0.2, 1.0), 5);
  EXPECT_EQ(relaxedRung(6, 2, 0.3, 1.0), 6);
}

TEST(LocalSteps, theLimitOfChangeFallsAsTheErrorOfHalfTheStepDoes) {
  // Two rungs of fineness halve the step; a rule of order 2 then errs by a quarter.
  EXPECT_DOUBLE_EQ(mostChange(2), mostChange(0) / 4.0);
}

TEST(LocalSteps, aPartOfARungShortensTheWholeLadder) {
  EXPECT_EQ(wholeRungs(3.75), 3);
  EXPECT_DOUBLE_EQ(ladderScale(3.0), 1.0);
  // A whole rung is a factor of the square root of 2, so half of one its root.
  EXPECT_DOUBLE_EQ(ladderScale(3.5), std::pow(2.0, -0.25));
}

TEST(LocalSteps, behindWhatHidesItABlockIsSampledWithTheInverseCubeRootOfTheTransmittance) {
  // 8^(1/3) = 2: two rungs; and 1/8 of that again.
  EXPECT_EQ(coarserBehind(1.0), 0);
  EXPECT_EQ(coarserBehind(0.124), 2);
  EXPECT_EQ(coarserBehind(0.0156), 4);
}

TEST(LocalSteps, aSceneWithoutAToleranceIsDrawnInEqualSteps) {
  Quality quality;
  EXPECT_FALSE(finenessOf(quality));
  quality.fineness = 3;
  EXPECT_FALSE(finenessOf(quality));
  quality.toleranceLevels = 1.0;
  EXPECT_EQ(finenessOf(quality), 3);
  quality.fineness.reset();
  EXPECT_EQ(finenessOf(quality), usualFineness(1.0));
  EXPECT_EQ(usualFineness(0.5), usualFineness(1.0) + 1);
}

TEST(BlockFacts, aRampHasItsSlopeEverywhereAndBendsAtItsEndsOnly) {
  // 9 voxels of 0.5 mm: 2 blocks along x; the field is constant beyond the outermost centres.
  const BlockFacts facts = blockFacts(volumeOf({9, 5, 5}, [](const glm::ivec3& i) { return 3.0 * i.x; }));
  EXPECT_EQ(facts.blocks, glm::ivec3(2, 1, 1));
  EXPECT_EQ(facts.facts[0].range, (ValueRange{0.0, 12.0}));
  EXPECT_EQ(facts.facts[1].range, (ValueRange{12.0, 24.0}));
  for (const FieldFacts& block : facts.facts) {
    EXPECT_DOUBLE_EQ(block.steepestPerMm, 6.0);
    EXPECT_DOUBLE_EQ(block.bendPerMm2, 12.0); // from 6 per mm to 0 within a voxel of 0.5 mm
  }
}

TEST(BlockFacts, theBendOfAParabolaIsItsSecondDerivative) {
  const BlockFacts facts =
      blockFacts(volumeOf({17, 5, 5}, [](const glm::ivec3& i) { return 2.0 * i.y * i.y; }));
  // Along y by 4 per mm², but at the ends: 0 to 2 at the first voxel, 14 to 0 at the last.
  EXPECT_DOUBLE_EQ(facts.facts[1].bendPerMm2, 14.0);
  EXPECT_DOUBLE_EQ(facts.facts[1].steepestPerMm, 14.0);
}

TEST(BlockSteps, aBlockWhoseValuesAreTransparentIsEmpty) {
  const BlockFacts facts = blockFacts(volumeOf({9, 5, 5}, [](const glm::ivec3& i) { return 3.0 * i.x; }));
  const BlockSteps steps = blockSteps(facts, peak(20.0, 1.0), 0.5);
  EXPECT_TRUE(steps.rungs[0].isEmpty);
  EXPECT_FALSE(steps.rungs[1].isEmpty);
}

TEST(LocalSteps, changeWithTheStepByTheSameRatio) {
  Quality quality;
  quality.stepVoxels = 0.5;
  EXPECT_EQ(withSteps(quality, 0.125).fineness, std::nullopt) << "equal steps have none";
  quality.toleranceLevels = 0.5;
  quality.fineness = 5;
  EXPECT_EQ(withSteps(quality, 0.125).fineness, 9) << "two rungs halve every step";
  EXPECT_EQ(withSteps(quality, 0.125).stepVoxels, 0.125);
  EXPECT_EQ(withSteps(quality, 2.0).fineness, 1);
  EXPECT_EQ(withSteps(quality, 16.0).fineness, Fineness::least);
  EXPECT_EQ(withSteps(withSteps(quality, 0.25), 0.5), quality);
}

TEST(BlockSteps, eightTimesTheExtinctionHalvesTheStep) {
  const BlockFacts facts = blockFacts(volumeOf({9, 5, 5}, [](const glm::ivec3& i) { return 3.0 * i.x; }));
  const auto plainAt = [&](double extinctionPerMm) {
    TransferFunction function;
    function.points.push_back({0.0, glm::dvec3(1.0), 1.0 - std::exp(-extinctionPerMm)});
    return blockSteps(facts, function, 0.5).rungs[0].plain;
  };
  EXPECT_EQ(plainAt(0.8), plainAt(0.1) + 2);
}

TEST(BlockSteps, aPeakOfTheFunctionGetsTwoSamplesWhereTheFieldIsSteepest) {
  // The peak is 0.15 wide, from half its height to half its height; the field changes by 6 per mm: 0.025 mm,
  // or 0.05 voxels, of which two steps are 0.025 voxels: rung ceil(2 log2(2/0.025)) = 13.
  const BlockFacts facts = blockFacts(volumeOf({9, 5, 5}, [](const glm::ivec3& i) { return 3.0 * i.x; }));
  const BlockSteps steps = blockSteps(facts, peak(20.0, 0.1), 0.5);
  EXPECT_EQ(steps.rungs[1].resolving, 13);
  EXPECT_TRUE(steps.resolvesFunction);
  EXPECT_EQ(rungIn(steps.rungs[1], 0, 1.0), 13);
  EXPECT_EQ(rungIn(steps.rungs[1], 0, 1e-3), 13) << "nothing may be missed, however little of it shows";
}

TEST(BlockSteps, aPeakThatTheFinestStepMissesIsSaid) {
  const BlockFacts facts = blockFacts(volumeOf({9, 5, 5}, [](const glm::ivec3& i) { return 3.0 * i.x; }));
  EXPECT_FALSE(blockSteps(facts, peak(20.0, 1e-3), 0.5).resolvesFunction);
  EXPECT_TRUE(blockSteps(facts, peak(40.0, 1e-3), 0.5).resolvesFunction) << "no voxel reaches it";
}

} // namespace
} // namespace limn
