// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Error.h"
#include "scene/regions/BlockWeights.h"
#include "scene/regions/BodyAndLabels.h"
#include "scene/regions/PackedLabels.h"

#include <gtest/gtest.h>

#include <random>

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

TEST(BodyAndLabels, multiply) {
  const glm::ivec3 dims(4, 3, 2);
  std::vector<std::uint8_t> places(24), kept(24);
  for (std::size_t n = 0; n < 24; ++n) {
    places[n] = static_cast<std::uint8_t>(n % 3);
    kept[n] = n % 4 != 0;
  }
  const Region labels =
      withLooks({Region::Kind::labels,
                 "seg",
                 std::make_shared<const LabelMap>(
                     dims, places, std::vector<Label>{{0, "", {}}, {5, "a", {}}, {9, "b", {}}}),
                 {1.0, 0.25, 0.0}},
                {{1, {1.0, {{3.0, {1, 0, 0}, 0.5}}}}});
  const Region body = bodyRegion(dims, kept);
  const Region both = withBody(labels, body);
  EXPECT_EQ(both.kind, Region::Kind::labels);
  EXPECT_TRUE(hidesTable(both));
  EXPECT_EQ(tableLabel(both), std::optional<std::size_t>(3));
  EXPECT_EQ(listedLabels(both), 3u);
  EXPECT_EQ(lookOfLabel(both, 1), 1u);
  for (std::size_t n = 0; n < 24; ++n)
    EXPECT_EQ(both.weights[both.labels->placeAt(n)],
              labels.weights[labels.labels->placeAt(n)] * body.weights[body.labels->placeAt(n)]);
  EXPECT_FALSE(hidesTable(labels));
  EXPECT_FALSE(tableLabel(labels));
  EXPECT_TRUE(hidesTable(body));
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

// A map of so many labels; each voxel has the one before's with a probability of `alike`.
template <class Place>
std::shared_ptr<const LabelMap> mapOf(const glm::ivec3& dims, int labels, double alike) {
  std::mt19937 random(7);
  std::vector<Place> places(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  for (std::size_t n = 1; n < places.size(); ++n)
    places[n] = std::bernoulli_distribution(alike)(random)
                    ? places[n - 1]
                    : static_cast<Place>(std::uniform_int_distribution(0, labels - 1)(random));
  std::vector<Label> names(static_cast<std::size_t>(labels));
  names.back().name = "last";
  return std::make_shared<const LabelMap>(dims, std::move(places), names);
}

TEST(PackedLabels, bringBackTheVeryMapOrOneThatIsEqual) {
  for (const double alike : {0.0, 0.5, 0.999, 1.0})
    for (const int labels : {1, 200, 3000}) {
      const glm::ivec3 dims(77, 13, 5);
      auto map =
          labels > 256 ? mapOf<std::uint16_t>(dims, labels, alike) : mapOf<std::uint8_t>(dims, labels, alike);
      const std::size_t voxelBytes = labels > 256 ? 2 : 1;
      const PackedLabels packed(map);
      EXPECT_EQ(packed.map(), map);
      EXPECT_TRUE(packed.isOf(map));
      EXPECT_LE(packed.bytes(), voxelBytes * 77 * 13 * 5);
      const LabelMap before = *map;
      map.reset();
      const auto after = packed.map();
      EXPECT_EQ(after->dims(), dims);
      EXPECT_EQ(after->labels(), before.labels());
      EXPECT_EQ(after->places(), before.places()) << labels << " labels, " << alike;
      EXPECT_EQ(packed.map(), after) << "the same one as long as it lives";
    }
}

TEST(PackedLabels, putAsideTakeNoMemoryAndComeBack) {
  const auto room = std::make_shared<Room>(), none = std::make_shared<Room>("/no such folder");
  const glm::ivec3 dims(77, 130, 50); // more than is worth a file
  auto map = mapOf<std::uint8_t>(dims, 200, 0.5);
  const PackedLabels packed(map);
  const std::size_t bytes = packed.bytes();
  EXPECT_EQ(packed.bytesInMemory(), bytes);
  packed.putAside(none);
  EXPECT_EQ(packed.bytesInMemory(), bytes) << "there is no place for them";
  packed.putAside(room);
  packed.putAside(room);
  EXPECT_EQ(packed.bytesInMemory(), 0u);
  EXPECT_EQ(packed.bytes(), bytes);
  EXPECT_GE(room->taken(), bytes);
  const LabelMap before = *map;
  map.reset();
  EXPECT_EQ(packed.map()->places(), before.places());

  const PackedLabels few(mapOf<std::uint8_t>({8, 8, 8}, 200, 0.5));
  EXPECT_GT(few.bytes(), 0u);
  few.putAside(room);
  EXPECT_EQ(few.bytesInMemory(), few.bytes()) << "not worth a file";
}

TEST(PackedLabels, ofAWideRowAndOfBlocksTakeFewBytes) {
  EXPECT_EQ(PackedLabels(mapOf<std::uint8_t>({200000, 1, 1}, 1, 1.0)).bytes(),
            4u * 3); // of at most 65535 each
  EXPECT_EQ(PackedLabels(mapOf<std::uint16_t>({64, 64, 64}, 1, 1.0)).bytes(), 64u * 64 * 4);
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
            (BlockWeights{BlockWeight::all, BlockWeight::varying, BlockWeight::varying, BlockWeight::none}))
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
