// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/GradientHistogram.h"
#include "scene/light/Gradient.h"

#include <gtest/gtest.h>

#include <numeric>

namespace limn {
namespace {

Volume row(std::vector<float> voxels) {
  Grid grid;
  grid.dims = {static_cast<int>(voxels.size()), 1, 1};
  return Volume(grid, std::move(voxels), {}, {}, {});
}

TEST(GradientHistogram, countsEveryModulusOnceFromZeroToTheLargest) {
  // Moduli of the squares 0,1,4,9,16 with one-sided ends: 1, 2, 4, 6, 7. Seven bins of 1 from 0 to 7; the
  // largest belongs to the last.
  const Histogram histogram = gradientHistogram(row({0, 1, 4, 9, 16}), 7);
  EXPECT_EQ(histogram.range, (ValueRange{0.0, 7.0}));
  EXPECT_EQ(histogram.counts, (std::vector<std::uint64_t>{0, 1, 1, 0, 1, 0, 2}));
}

TEST(GradientHistogram, leavesOutWhatIsNotEligible) {
  Grid grid;
  grid.dims = {5, 1, 1};
  const Volume volume(grid, std::vector<std::int16_t>{0, 1, 2, 3, -2000}, {}, PaddingRange{-2000, -2000}, {});
  const Histogram histogram = gradientHistogram(volume, 4);
  EXPECT_EQ(histogram.range.highest, 1.0);
  // The last voxel is invalid and the one before it has it in its stencil.
  EXPECT_EQ(histogram.counts, (std::vector<std::uint64_t>{0, 0, 0, 3}));
}

TEST(GradientHistogram, ofAConstantVolumeIsOneBin) {
  const Histogram histogram = gradientHistogram(row({5, 5, 5}));
  EXPECT_EQ(histogram.counts, std::vector<std::uint64_t>{3});
  EXPECT_EQ(boundaryRamp(histogram), (GradientOpacity{{{0.0, 1.0}}}));
}

TEST(GradientHistogram, theRampRunsBetweenItsPercentiles) {
  // A thousand moduli, one in the middle of each of a thousand bins from 0 to 1000: the 600th is 599.5, the
  // 970th 969.5.
  Histogram histogram{{0.0, 1000.0}, std::vector<std::uint64_t>(1000, 1)};
  const GradientOpacity ramp = boundaryRamp(histogram);
  EXPECT_EQ(ramp, (GradientOpacity{{{599.5, 0.0}, {969.5, 1.0}}}));
}

TEST(GradientHistogram, theRampOfAVolumeOfLabelsIsNoStep) {
  Histogram histogram{{0.0, 2.0}, std::vector<std::uint64_t>(100, 0)};
  histogram.counts[0] = 990;
  histogram.counts[60] = 10;
  EXPECT_EQ(boundaryRamp(histogram), (GradientOpacity{{{0.0, 0.0}, {1.0, 1.0}}}));
}

TEST(GradientHistogram, holdsAllVoxelsOfAVolumeOfManySlices) {
  Grid grid;
  grid.dims = {7, 6, 23};
  std::vector<double> voxels(7 * 6 * 23);
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = static_cast<double>(i * i % 101);
  const Volume volume(grid, voxels, {}, {}, {});
  const Histogram histogram = gradientHistogram(volume);
  EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0}),
            voxels.size());
  EXPECT_EQ(histogram.range.highest, largestGradient(volume));
}

} // namespace
} // namespace limn
