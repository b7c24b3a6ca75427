// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/Reduction.h"
#include "PhantomScene.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

std::shared_ptr<const Volume> volumeOf(const glm::ivec3& dims, std::vector<std::int16_t> stored,
                                       const Rescale& rescale = {}) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {2.0, 3.0, 5.0};
  grid.originMm = {10.0, 20.0, 30.0};
  return std::make_shared<const Volume>(grid, std::move(stored), rescale, std::nullopt, VolumeInfo{});
}

TEST(Reduction, isEvenInMillimetresAndNeverBeyondAnAxis) {
  Grid grid;
  grid.dims = {512, 512, 100};
  grid.spacingMm = {0.5, 0.5, 2.0};
  EXPECT_EQ(reductionTo(grid, std::size_t{512} * 512 * 100), glm::ivec3(1));
  EXPECT_EQ(reductionTo(grid, std::size_t{128} * 128 * 100), glm::ivec3(4, 4, 1));
  grid.dims = {4096, 4096, 1};
  EXPECT_EQ(reductionTo(grid, std::size_t{1024} * 1024), glm::ivec3(4, 4, 1));
  grid.dims = {3, 1, 1};
  EXPECT_EQ(reductionTo(grid, 1), glm::ivec3(3, 1, 1));
}

TEST(Reduction, takesTheMeanOfEachBoxAndOfWhatTheLastOnesHold) {
  const auto volume = volumeOf({3, 2, 1},
                               {1, 3, 10, //
                                5, 7, 20},
                               {2.0, 100.0});
  const auto coarse = reduced(volume, {2, 2, 1});
  ASSERT_EQ(coarse->grid().dims, glm::ivec3(2, 1, 1));
  EXPECT_DOUBLE_EQ(coarse->value({0, 0, 0}), 2.0 * 4.0 + 100.0);
  EXPECT_DOUBLE_EQ(coarse->value({1, 0, 0}), 2.0 * 15.0 + 100.0);
}

// What lies in the middle of a box must lie there still.
TEST(Reduction, leavesThingsWhereTheyAre) {
  const auto volume = volumeOf({4, 4, 4}, std::vector<std::int16_t>(64, 7));
  const auto coarse = reduced(volume, {2, 4, 1});
  const glm::dvec3 middle = indexToWorld(coarse->grid(), {0.0, 0.0, 0.0});
  EXPECT_EQ(middle, indexToWorld(volume->grid(), {0.5, 1.5, 0.0}));
  EXPECT_EQ(coarse->grid().spacingMm, glm::dvec3(4.0, 12.0, 5.0));
  EXPECT_EQ(reduced(volume, glm::ivec3(1)), volume) << "the same voxels, shared";
}

TEST(Reduction, keepsWhatTheMiddleOfABoxKeeps) {
  std::vector<std::uint8_t> places{0, 1, 1, 1, 0};
  const Region coarse = reduced(bodyRegion({5, 1, 1}, places), {2, 1, 1});
  ASSERT_EQ(coarse.labels->dims(), glm::ivec3(3, 1, 1));
  EXPECT_DOUBLE_EQ(weightAt(coarse, {0, 0, 0}), 1.0);
  EXPECT_DOUBLE_EQ(weightAt(coarse, {1, 0, 0}), 1.0);
  EXPECT_DOUBLE_EQ(weightAt(coarse, {2, 0, 0}), 0.0);
  EXPECT_EQ(reduced(Region{}, {2, 2, 2}), Region{});
}

TEST(Reduction, endsWhenItIsToldTo) {
  const Scene scene = test::roughPhantomScene();
  EXPECT_THROW(reduced(scene.volume, {2, 2, 2}, {1, [] { return true; }, {}}), Cancelled);
}

} // namespace
} // namespace limn
