// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Volume.h"
#include "scene/basics/Error.h"
#include "scene/volume/Histogram.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace limn {
namespace {

Grid gridOf(int x, int y, int z) {
  Grid grid;
  grid.dims = {x, y, z};
  return grid;
}

TEST(Volume, replacesNanAndInfinityByTheSmallestValidValue) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const Volume volume(gridOf(4, 1, 1), std::vector<float>{5.0f, nan, -2.0f, inf}, {}, {}, {});
  EXPECT_EQ(volume.invalidVoxels(), 2u);
  EXPECT_EQ(volume.value({1, 0, 0}), -2.0);
  EXPECT_EQ(volume.value({3, 0, 0}), -2.0);
  EXPECT_EQ(volume.range(), (ValueRange{-2.0, 5.0}));
}

TEST(Volume, comparesPaddingInStoredValuesAndReplacesByTheSmallestScalarUnderANegativeSlope) {
  // Slope -1: the stored value 30 is the smallest scalar.
  const Volume volume(gridOf(4, 1, 1), std::vector<std::int16_t>{10, -2000, 30, 20}, {-1.0, 0.0},
                      PaddingRange{-2000, -2000}, {});
  EXPECT_EQ(volume.invalidVoxels(), 1u);
  EXPECT_EQ(volume.value({1, 0, 0}), -30.0);
  EXPECT_EQ(volume.range(), (ValueRange{-30.0, -10.0}));
}

TEST(Volume, refusesAVolumeWithoutAValidVoxel) {
  EXPECT_THROW(Volume(gridOf(2, 1, 1), std::vector<std::uint8_t>{7, 7}, {}, PaddingRange{7, 7}, {}), Error);
}

TEST(Volume, refusesAnArrayThatDoesNotMatchItsDimensions) {
  EXPECT_THROW(Volume(gridOf(2, 2, 2), std::vector<std::uint8_t>(7), {}, {}, {}), Error);
}

TEST(Volume, refusesValuesWhoseDifferencesAreNoNumbers) {
  const double largest = std::numeric_limits<double>::max();
  EXPECT_THROW(Volume(gridOf(2, 1, 1), std::vector<double>{-largest, largest}, {}, {}, {}), Error);
  const float most = std::numeric_limits<float>::max();
  EXPECT_EQ(Volume(gridOf(2, 1, 1), std::vector<float>{-most, most}, {}, {}, {}).range().highest, most);
}

TEST(Volume, interpolatesBetweenCentresAndClampsBeyondThem) {
  const Volume volume(gridOf(2, 2, 1), std::vector<std::uint8_t>{0, 10, 20, 30}, {}, {}, {});
  EXPECT_DOUBLE_EQ(valueAt(volume, {0.5, 0.5, 0.0}), 15.0);
  EXPECT_DOUBLE_EQ(valueAt(volume, {-0.5, 0.0, 0.4}), 0.0);
  EXPECT_DOUBLE_EQ(valueAt(volume, {1.5, 1.5, -0.5}), 30.0);
}

TEST(Histogram, countsEveryValidVoxelOnce) {
  const Volume volume(gridOf(5, 1, 1), std::vector<std::int16_t>{-9, 0, 50, 100, 100}, {},
                      PaddingRange{-9, -9}, {});
  const Histogram histogram = histogramOf(volume, 10);
  EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0}), 4u);
  // 101 values in 10 bins of 11 each, from -0.5: 50 lies in the fifth.
  EXPECT_EQ(histogram.range, (ValueRange{-0.5, 109.5}));
  EXPECT_EQ(histogram.counts.front(), 1u);
  EXPECT_EQ(histogram.counts[4], 1u);
  EXPECT_EQ(histogram.counts.back(), 2u);
}

TEST(Histogram, ofIntegersHasNoComb) {
  // Every value of 0..255 once, scaled as MR files scale them: each bin holds one.
  std::vector<std::uint8_t> voxels(256);
  std::iota(voxels.begin(), voxels.end(), std::uint8_t{0});
  const Volume volume(gridOf(256, 1, 1), voxels, {2.00784, -3.0}, {}, {});
  for (const std::uint64_t count : histogramOf(volume, 1024).counts)
    EXPECT_EQ(count, 1u);
}

TEST(Histogram, ofAConstantVolumeIsOneBin) {
  const Volume volume(gridOf(2, 2, 1), std::vector<float>(4, 3.0f), {}, {}, {});
  EXPECT_EQ(histogramOf(volume).counts, std::vector<std::uint64_t>{4});
}

TEST(Volume, valuesWhoseRangeIsNoNumberAreRefused) {
  Grid grid;
  grid.dims = {2, 1, 1};
  const double most = std::numeric_limits<double>::max();
  EXPECT_THROW(Volume(grid, std::vector<double>{-most, most}, Rescale{}, std::nullopt, VolumeInfo{}), Error);
}

} // namespace
} // namespace limn
