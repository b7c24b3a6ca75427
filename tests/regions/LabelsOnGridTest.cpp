// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/LabelsOnGrid.h"

#include "Sets.h"

#include "scene/basics/Error.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace limn {
namespace {

Grid gridOf(const glm::ivec3& dims, const glm::dvec3& spacingMm = glm::dvec3(1.0)) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = spacingMm;
  return grid;
}

template <class T>
Volume volumeOf(const Grid& grid, std::vector<T> stored, const Rescale& rescale = {}) {
  return Volume(grid, std::move(stored), rescale, std::nullopt, {});
}

int valueAt(const LabelMap& map, const glm::ivec3& voxel) {
  return map.labels()[map.placeAt(voxelOffset(map.dims(), voxel.x, voxel.y, voxel.z))].value;
}

TEST(LabelsOnGrid, ofTheSameGridAreThemselves) {
  const Grid grid = gridOf({4, 2, 1});
  const auto map = labelsOnGrid(volumeOf<std::int16_t>(grid, {0, 7, 7, -2, 300, 0, 7, 300}),
                                {{7, "Liver", {0.1, 0.2, 0.3}}, {9, "not there", {}}}, grid);
  ASSERT_EQ(map->labels().size(), 4u);
  EXPECT_EQ(map->labels()[0], (Label{0, "Background", glm::dvec3(0.5)}));
  EXPECT_EQ(map->labels()[1].value, -2);
  EXPECT_EQ(map->labels()[1].name, "Label -2");
  EXPECT_EQ(map->labels()[2], (Label{7, "Liver", {0.1, 0.2, 0.3}}));
  EXPECT_EQ(map->labels()[3].value, 300);
  EXPECT_EQ(std::get<0>(map->places()), (std::vector<std::uint8_t>{0, 2, 2, 1, 3, 0, 2, 3}));
}

TEST(LabelsOnGrid, ofAnotherGridAreTheNearest) {
  // Labels in voxels of 2 mm whose first centre lies at (10, 20, 30), columns towards -x; the volume's voxels
  // are cubes of 1 mm. World x of label i is 10 - 2i, so that x = 9.4 is nearest to i = 0, x = 8.6 to i = 1.
  Grid coarse = gridOf({3, 1, 1}, {2.0, 50.0, 50.0});
  coarse.originMm = {10, 20, 30};
  coarse.direction = glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1);
  Grid fine = gridOf({8, 1, 1});
  fine.originMm = {4.4, 25, 25};
  const auto map = labelsOnGrid(volumeOf<std::uint8_t>(coarse, {1, 2, 3}), {}, fine);
  // x = 4.4 lies outside (beyond 5), 5.4 and 6.4 are nearest to 6, 7.4 and 8.4 to 8, 9.4 and 10.4 to 10; 11.4
  // is outside (beyond 11).
  for (const auto& [x, value] :
       std::map<int, int>{{0, 0}, {1, 3}, {2, 3}, {3, 2}, {4, 2}, {5, 1}, {6, 1}, {7, 0}})
    EXPECT_EQ(valueAt(*map, {x, 0, 0}), value) << x;
}

TEST(LabelsOnGrid, tiesFallTheSameWayEverywhere) {
  // Centres of the fine grid lie between two labels, up to rounding.
  const Grid coarse = gridOf({101, 1, 1}, {0.1, 1, 1});
  Grid fine = gridOf({100, 1, 1}, {0.1, 1, 1});
  fine.originMm.x = 0.05;
  std::vector<std::uint8_t> values(101);
  std::iota(values.begin(), values.end(), std::uint8_t{1});
  const auto map = labelsOnGrid(volumeOf(coarse, values), {}, fine);
  for (int x = 0; x < 100; ++x)
    EXPECT_EQ(valueAt(*map, {x, 0, 0}), x + 2);
}

TEST(LabelsOnGrid, mayBeTenThousand) {
  const Grid grid = gridOf({100, 100, 2});
  std::vector<std::int32_t> values(20000);
  std::iota(values.begin(), values.end(), -5000);
  const auto map = labelsOnGrid(volumeOf(grid, values), {}, grid);
  EXPECT_EQ(map->labels().size(), 20000u);
  EXPECT_EQ(map->labels().front().value, 0);
  EXPECT_EQ(valueAt(*map, {99, 99, 1}), 14999);
  // Neighbours in the list can be told apart.
  for (std::size_t n = 1; n < 50; ++n)
    EXPECT_GT(glm::length(map->labels()[n].color - map->labels()[n + 1].color), 0.25) << n;
}

TEST(LabelsOnGrid, mayBeRescaledAndPadded) {
  const Grid grid = gridOf({3, 1, 1});
  const float gap = std::numeric_limits<float>::quiet_NaN();
  const auto map = labelsOnGrid(volumeOf<float>(grid, {1.0f, gap, 2.0f}, {2.0, 1.0}), {}, grid);
  EXPECT_EQ(valueAt(*map, {0, 0, 0}), 3);
  EXPECT_EQ(valueAt(*map, {1, 0, 0}), 0) << "what the file does not say is background";
  EXPECT_EQ(valueAt(*map, {2, 0, 0}), 5);
}

TEST(LabelsOnGrid, areRefusedWhereTheyAreNone) {
  const Grid grid = gridOf({2, 1, 1}), large = gridOf({70000, 1, 1});
  EXPECT_THROW(labelsOnGrid(volumeOf<float>(grid, {1.0f, 1.5f}), {}, grid), Error);
  EXPECT_THROW(labelsOnGrid(volumeOf<double>(grid, {0.0, 1e12}), {}, grid), Error);
  std::vector<std::int32_t> values(70000);
  std::iota(values.begin(), values.end(), 1);
  EXPECT_THROW(labelsOnGrid(volumeOf(large, values), {}, large), Error);
}

TEST(LabelsOnGrid, ofAlignedAxesInAnotherOrderAreTheSameAsOfTurnedOnes) {
  // The label grid's axes are the volume's z, -x and y; every voxel has its own label.
  Grid from = gridOf({4, 3, 5}, {1.5, 2.0, 1.0});
  from.originMm = {-3.0, 7.0, 2.0};
  Grid to = gridOf({6, 5, 4}, {1.0, 1.5, 2.0});
  to.direction = glm::dmat3(0, 0, 1, -1, 0, 0, 0, 1, 0);
  to.originMm = indexToWorld(from, {3.2, -0.4, -0.3});
  std::vector<std::uint16_t> values(6 * 5 * 4);
  std::iota(values.begin(), values.end(), std::uint16_t{1});
  const auto map = labelsOnGrid(volumeOf(to, values), {}, from);
  int inside = 0;
  for (int z = 0; z < from.dims.z; ++z)
    for (int y = 0; y < from.dims.y; ++y)
      for (int x = 0; x < from.dims.x; ++x) {
        const glm::ivec3 nearest(glm::floor(worldToIndex(to, indexToWorld(from, {x, y, z})) + 0.5));
        const bool isInside = glm::all(glm::greaterThanEqual(nearest, glm::ivec3(0))) &&
                              glm::all(glm::lessThan(nearest, to.dims));
        inside += isInside ? 1 : 0;
        const std::size_t voxel = isInside ? voxelOffset(to.dims, nearest.x, nearest.y, nearest.z) : 0;
        ASSERT_EQ(valueAt(*map, {x, y, z}), isInside ? static_cast<int>(values[voxel]) : 0)
            << x << ' ' << y << ' ' << z;
      }
  EXPECT_GT(inside, 20);
}

TEST(MasksOnGrid, knowsMasksFromImages) {
  const Grid grid = gridOf({4, 1, 1});
  EXPECT_TRUE(isMask(volumeOf<std::uint8_t>(grid, {0, 1, 1, 0})));
  EXPECT_TRUE(isMask(volumeOf<std::uint8_t>(grid, {0, 255, 0, 0})));
  EXPECT_TRUE(isMask(volumeOf<float>(grid, {0.0f, 1.0f, 1.0f, 0.0f})));
  EXPECT_TRUE(isMask(volumeOf<std::uint8_t>(grid, {0, 0, 0, 0}))) << "of a structure that is not there";
  EXPECT_TRUE(isMask(volumeOf<std::uint8_t>(grid, {1, 1, 1, 1})));
  EXPECT_FALSE(isMask(volumeOf<std::uint8_t>(grid, {0, 1, 2, 0})));
  EXPECT_FALSE(isMask(volumeOf<std::int16_t>(grid, {0, -1, 0, -1})));
  EXPECT_FALSE(isMask(volumeOf<std::int16_t>(grid, {1, 2, 1, 2})));
  EXPECT_TRUE(isMask(volumeOf<std::uint8_t>(grid, {1, 3, 1, 1}, {0.5, -0.5}))) << "0 and 1 as they are meant";
}

} // namespace
} // namespace limn
