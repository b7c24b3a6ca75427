// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Error.h"
#include "scene/regions/BlockWeights.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

Region rowOf(const std::vector<double>& weights) {
  std::vector<Label> labels;
  std::vector<std::uint16_t> places;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    labels.push_back({static_cast<int>(i), "", glm::dvec3(1.0)});
    places.push_back(static_cast<std::uint16_t>(i));
  }
  const glm::ivec3 dims(static_cast<int>(weights.size()), 1, 1);
  return {Region::Kind::labels, "", std::make_shared<const LabelMap>(dims, places, labels), weights};
}

TEST(LabelMap, refusesWhatDoesNotFit) {
  const std::vector<Label> labels{{0, "Background", glm::dvec3(1.0)}};
  EXPECT_THROW(LabelMap({2, 1, 1}, std::vector<std::uint8_t>{0}, labels), Error);
  EXPECT_THROW(LabelMap({1, 1, 1}, std::vector<std::uint8_t>{1}, labels), Error);
  EXPECT_THROW(LabelMap({1, 1, 1}, std::vector<std::uint8_t>{0}, {}), Error);
  EXPECT_EQ(LabelMap({1, 1, 1}, std::vector<std::uint16_t>{0}, labels).placeAt(0), 0u);
}

TEST(LabelMap, knowsTheBoxAroundEachLabel) {
  std::vector<std::uint8_t> places(4 * 3 * 2, 0);
  places[1 + 4 * 1] = places[2 + 4 * (0 + 3 * 1)] = 2; // voxels (1, 1, 0) and (2, 0, 1)
  const std::vector<Label> labels(3);
  const LabelMap map({4, 3, 2}, places, labels);
  EXPECT_EQ(map.boxAround(0).lower, glm::ivec3(0));
  EXPECT_EQ(map.boxAround(0).upper, glm::ivec3(4, 3, 2));
  EXPECT_EQ(map.boxAround(1).lower, map.boxAround(1).upper) << "no voxel has it";
  EXPECT_EQ(map.boxAround(2).lower, glm::ivec3(1, 0, 0));
  EXPECT_EQ(map.boxAround(2).upper, glm::ivec3(3, 2, 2));
}

TEST(Region, restrictsWhereALabelWeighsLess) {
  EXPECT_FALSE(isRestricting(Region{}));
  EXPECT_FALSE(isRestricting(Region{Region::Kind::body, {}, {}, {}})) << "not found yet";
  EXPECT_FALSE(isRestricting(rowOf({1.0, 1.0})));
  EXPECT_TRUE(isRestricting(rowOf({1.0, 0.999})));
}

TEST(Region, weighsLinearlyBetweenVoxelCentresAndIsClampedBeyond) {
  const Region region = rowOf({0.25, 1.0, 0.0});
  EXPECT_DOUBLE_EQ(weightAt(region, {0.0, 0.0, 0.0}), 0.25);
  EXPECT_DOUBLE_EQ(weightAt(region, {0.5, 0.0, 0.0}), 0.625);
  EXPECT_DOUBLE_EQ(weightAt(region, {1.75, 0.3, -0.4}), 0.25);
  EXPECT_DOUBLE_EQ(weightAt(region, {-0.5, 0.0, 0.0}), 0.25);
  EXPECT_DOUBLE_EQ(weightAt(region, {2.5, 0.0, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(weightAt(Region{}, {7.0, 0.0, 0.0}), 1.0);
}

TEST(Region, weighsTrilinearlyInThreeDimensions) {
  std::vector<std::uint8_t> places(8, 0);
  places[7] = 1;
  const Region region = bodyRegion(glm::ivec3(2), places);
  EXPECT_DOUBLE_EQ(weightAt(region, {0.5, 0.25, 0.75}), 0.5 * 0.25 * 0.75);
}

TEST(Region, hasSharesThatAreItsWeightsToTheSixteenthBit) {
  const Region region = rowOf({0.0, 0.4, 1.0});
  std::uint16_t shares[2];
  sharesOf(region, 1, 2, shares);
  EXPECT_EQ(shares[0], 26214); // 0.4 · 65535
  EXPECT_EQ(shares[1], 65535);
}

// Blocks of 4 cells in a row of 17 voxels: 0..4, 4..8, 8..12, 12..16, each with one voxel more on either
// side.
TEST(BlockWeights, tellWhatIsLeftOfEachBlock) {
  std::vector<double> weights(17, 1.0);
  std::fill(weights.begin() + 8, weights.end(), 0.0);
  const auto kinds = blockWeights(rowOf(weights), {{4, 1, 1}, glm::ivec3(4)});
  EXPECT_EQ(kinds,
            (BlockWeights{BlockWeight::same, BlockWeight::varying, BlockWeight::varying, BlockWeight::none}))
      << "nothing is left of the voxels of the third, but of the one beside them";
}

TEST(BlockWeights, ofAnEvenFractionAreTheSame) {
  const auto kinds = blockWeights(rowOf(std::vector<double>(17, 0.5)), {{4, 1, 1}, glm::ivec3(4)});
  EXPECT_EQ(kinds, BlockWeights(4, BlockWeight::same));
}

TEST(BlockWeights, areTheSameOnAnyNumberOfThreadsAndCanBeCancelled) {
  const glm::ivec3 dims(40, 31, 22);
  std::vector<std::uint8_t> places;
  for (int i = 0; i < dims.x * dims.y * dims.z; ++i)
    places.push_back(static_cast<std::uint8_t>(i / 3000 % 2));
  const Region region = bodyRegion(dims, places);
  const BlockGrid grid{{10, 8, 6}, glm::ivec3(4)};
  EXPECT_EQ(blockWeights(region, grid, {1, {}, {}}), blockWeights(region, grid, {4, {}, {}}));
  EXPECT_THROW(blockWeights(region, grid, {2, [] { return true; }, {}}), Cancelled);
}

} // namespace
} // namespace limn
