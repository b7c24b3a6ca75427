// SPDX-License-Identifier: GPL-3.0-or-later
// The field whose gradient smooth normals follow (DEFINITION section 2) against closed forms.
#include "scene/light/GradientSmoothing.h"

#include "scene/light/Gradient.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace limn {
namespace {

// Scalars are floats, of which a few are added up.
constexpr double ofRange = 0x1p-22;

std::shared_ptr<const Volume> fieldOf(const glm::ivec3& dims, const glm::dvec3& spacingMm,
                                      const std::function<double(const glm::ivec3&)>& scalarAt) {
  std::vector<double> voxels;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        voxels.push_back(scalarAt({i, j, k}));
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = spacingMm;
  return std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{});
}

std::shared_ptr<const Volume> noiseOf(const glm::ivec3& dims, const glm::dvec3& spacingMm) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> scalar(-1000.0, 3000.0);
  return fieldOf(dims, spacingMm, [&](const glm::ivec3&) { return scalar(random); });
}

double widthOf(const Volume& volume) {
  return volume.range().highest - volume.range().lowest;
}

// The definition itself: the sum over all three axes at once.
double weighedAt(const Volume& volume, double sigmaMm, const glm::ivec3& at) {
  const Grid& grid = volume.grid();
  const glm::ivec3 reach = glm::ivec3(glm::floor(3.0 * sigmaMm / grid.spacingMm + 1e-9));
  double sum = 0.0, weights = 0.0;
  for (int z = -reach.z; z <= reach.z; ++z)
    for (int y = -reach.y; y <= reach.y; ++y)
      for (int x = -reach.x; x <= reach.x; ++x) {
        const glm::dvec3 away = glm::dvec3(x, y, z) * grid.spacingMm;
        const double weight = std::exp(-0.5 * glm::dot(away, away) / (sigmaMm * sigmaMm));
        sum += weight * volume.value(glm::clamp(at + glm::ivec3(x, y, z), glm::ivec3(0), grid.dims - 1));
        weights += weight;
      }
  return sum / weights;
}

TEST(GradientSmoothing, weightsAreThoseOfAGaussianCutAtThreeSigma) {
  const std::vector<double> weights = smoothingWeights(2.0, 1.5, 100);
  ASSERT_EQ(weights.size(), 5u); // 4 · 1.5 = 6 = 3σ
  double sum = -weights[0];
  for (const double weight : weights)
    sum += 2.0 * weight;
  EXPECT_NEAR(sum, 1.0, 1e-15);
  EXPECT_NEAR(weights[3] / weights[0], std::exp(-0.5 * 4.5 * 4.5 / 4.0), 1e-15);
  EXPECT_EQ(smoothingWeights(0.1, 0.3, 100).size(), 2u); // 3σ is one voxel, however it rounds
  EXPECT_EQ(smoothingWeights(0.0, 1.0, 100), std::vector<double>{1.0});
}

TEST(GradientSmoothing, whatReachesBeyondTheEdgesIsTheEdges) {
  // Of two voxels all neighbours are the other or the voxel itself.
  const std::vector<double> weights = smoothingWeights(5.0, 1.0, 2);
  ASSERT_EQ(weights.size(), 2u);
  EXPECT_NEAR(weights[0] + 2.0 * weights[1], 1.0, 1e-15);
  EXPECT_EQ(smoothingWeights(5.0, 1.0, 1), std::vector<double>{1.0});
}

TEST(GradientSmoothing, isTheSumOverAllThreeAxesAtOnce) {
  const auto volume = noiseOf({21, 13, 9}, {1.0, 0.7, 3.1});
  for (const double sigma : {0.4, 1.3, 4.0}) {
    const auto smoothed = smoothedVolume(volume, sigma);
    for (const glm::ivec3& at :
         {glm::ivec3(0), glm::ivec3(20, 12, 8), glm::ivec3(10, 6, 4), glm::ivec3(1, 11, 0)})
      EXPECT_NEAR(smoothed->value(at), weighedAt(*volume, sigma, at), ofRange * widthOf(*volume)) << sigma;
  }
}

TEST(GradientSmoothing, leavesALinearFieldAsItIsInside) {
  // Slices ten times as thick as pixels.
  const auto volume = fieldOf({60, 60, 12}, {1.0, 1.0, 10.0},
                              [](const glm::ivec3& i) { return 2.0 * i.x + 3.0 * i.y - 50.0 * i.z; });
  const auto smoothed = smoothedVolume(volume, 7.0); // reaches 21 pixels and 2 slices
  for (const glm::ivec3& at : {glm::ivec3(30, 30, 6), glm::ivec3(21, 38, 2), glm::ivec3(22, 22, 9)})
    EXPECT_NEAR(smoothed->value(at), volume->value(at), ofRange * widthOf(*volume));
  const glm::dvec3 gradient = gradientAtVoxel(*smoothed, {30, 30, 5});
  // Two values off by as much as each may be, over two spacings.
  EXPECT_LT(glm::length(gradient - glm::dvec3(2.0, 3.0, -5.0)), 2.0 * ofRange * widthOf(*volume));
  // At the edge of the volume slopes become flatter, but along no other axis.
  EXPECT_LT(gradientAtVoxel(*smoothed, {0, 30, 5}).x, 1.5);
  EXPECT_NEAR(gradientAtVoxel(*smoothed, {0, 30, 5}).y, 3.0, 1e-3);
}

// The second moment of a field along an axis, mm².
double momentAlong(const Volume& volume, int axis) {
  const glm::ivec3 dims = volume.grid().dims;
  double sum = 0.0, moment = 0.0;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) {
        const double away = (glm::ivec3(i, j, k)[axis] - dims[axis] / 2) * volume.grid().spacingMm[axis];
        const double value = volume.value({i, j, k});
        sum += value;
        moment += value * away * away;
      }
  return moment / sum;
}

TEST(GradientSmoothing, widensAGaussianBlobByTheSumOfSquares) {
  const double blob = 2.0, sigma = 1.5;
  const glm::dvec3 spacing(0.8, 0.8, 1.2);
  const auto volume = fieldOf({49, 49, 33}, spacing, [&](const glm::ivec3& i) {
    const glm::dvec3 away = glm::dvec3(i - glm::ivec3(24, 24, 16)) * spacing;
    return std::exp(-0.5 * glm::dot(away, away) / (blob * blob));
  });
  const auto smoothed = smoothedVolume(volume, sigma);
  for (int axis = 0; axis < 3; ++axis) {
    // Moments of what is convolved add up; those of the weights are known.
    const std::vector<double> weights = smoothingWeights(sigma, spacing[axis], 1000);
    double ofWeights = 0.0;
    for (std::size_t n = 1; n < weights.size(); ++n)
      ofWeights += 2.0 * weights[n] * std::pow(static_cast<double>(n) * spacing[axis], 2.0);
    // Floats of which a third of a million are added up.
    EXPECT_NEAR(momentAlong(*smoothed, axis), momentAlong(*volume, axis) + ofWeights, 1e-3);
    // Cut off at 3σ a Gaussian has 1 - 6φ(3)/erf(3/√2) = 0.9733 of its variance.
    EXPECT_NEAR(momentAlong(*smoothed, axis), blob * blob + 0.9733 * sigma * sigma, 0.04);
  }
  // The peak falls to (s²/(s²+σ²))^1.5 = 0.5120 of itself, a little less for what is cut off.
  EXPECT_NEAR(smoothed->value({24, 24, 16}), 0.5120, 0.01);
}

TEST(GradientSmoothing, makesAStepTheSumOfItsWeights) {
  const auto volume =
      fieldOf({40, 3, 3}, {0.5, 1.0, 1.0}, [](const glm::ivec3& i) { return i.x < 20 ? 0.0 : 1.0; });
  const double sigma = 1.6; // 9 voxels
  const auto smoothed = smoothedVolume(volume, sigma);
  const std::vector<double> weights = smoothingWeights(sigma, 0.5, 40);
  for (int i = 0; i < 40; ++i) {
    double expected = 0.0;
    for (int n = -9; n <= 9; ++n)
      expected += i + n >= 20 ? weights[static_cast<std::size_t>(std::abs(n))] : 0.0;
    EXPECT_NEAR(smoothed->value({i, 1, 1}), expected, ofRange);
    // The integral of the Gaussian between the voxel and the step, but for the 0.27 % that are cut off and
    // the sum that stands for it.
    EXPECT_NEAR(smoothed->value({i, 1, 1}), 0.5 * std::erfc((19.5 - i) * 0.5 / (sigma * std::sqrt(2.0))),
                0.003);
  }
  EXPECT_EQ(smoothed->value({10, 1, 1}), 0.0);
  EXPECT_NEAR(smoothed->value({29, 1, 1}), 1.0, ofRange);
}

TEST(GradientSmoothing, leavesAConstantToTheLastBit) {
  const auto volume =
      fieldOf({30, 20, 10}, {1.0, 1.0, 4.0}, [](const glm::ivec3& i) { return i.x == 0 ? 0.0 : 1.0 / 3.0; });
  const auto smoothed = smoothedVolume(volume, 3.0);
  const double inside = smoothed->value({20, 10, 5});
  EXPECT_NEAR(inside, 1.0 / 3.0, 1e-7);
  for (const glm::ivec3& at : {glm::ivec3(11, 0, 0), glm::ivec3(29, 19, 9), glm::ivec3(15, 3, 7)})
    EXPECT_EQ(smoothed->value(at), inside);
}

TEST(GradientSmoothing, ofOneSliceGoesWithinIt) {
  const auto volume = noiseOf({12, 14, 1}, {1.0, 1.0, 5.0});
  const auto smoothed = smoothedVolume(volume, 2.0);
  EXPECT_NEAR(smoothed->value({5, 6, 0}), weighedAt(*volume, 2.0, {5, 6, 0}), ofRange * widthOf(*volume));
  EXPECT_EQ(gradientAtVoxel(*smoothed, {5, 6, 0}).z, 0.0);
}

TEST(GradientSmoothing, finerThanAVoxelIsNone) {
  const auto volume = noiseOf({8, 8, 8}, {1.0, 1.0, 3.0});
  EXPECT_FALSE(smoothsAnything(0.0, volume->grid()));
  EXPECT_FALSE(smoothsAnything(0.33, volume->grid()));
  EXPECT_TRUE(smoothsAnything(0.34, volume->grid()));
  const auto smoothed = smoothedVolume(volume, 0.33);
  for (const glm::ivec3& at : {glm::ivec3(0), glm::ivec3(3, 4, 5)})
    EXPECT_NEAR(smoothed->value(at), volume->value(at), 0x1p-24 * widthOf(*volume));
}

TEST(GradientSmoothing, isAskedForWhereSlicesAreThickByAQuarter) {
  const auto ofSpacing = [](const glm::dvec3& spacingMm, const glm::ivec3& dims = {9, 9, 9}) {
    Grid grid;
    grid.dims = dims;
    grid.spacingMm = spacingMm;
    return smoothingOfSlices(grid);
  };
  EXPECT_EQ(ofSpacing({1.0, 1.0, 1.0}), 0.0);
  EXPECT_EQ(ofSpacing({1.0, 0.5, 1.0}), 0.0); // two axes alike: which are the slices?
  EXPECT_EQ(ofSpacing({1.0, 1.0, 1.24}), 0.0);
  EXPECT_NEAR(ofSpacing({1.0, 1.0, 1.25}), 0.7 * 1.25, 1e-15);
  EXPECT_NEAR(ofSpacing({5.0, 1.0, 0.9}), 0.7 * 5.0, 1e-15); // along any axis
  EXPECT_EQ(ofSpacing({1.0, 1.0, 50.0}), mostGradientSmoothing);
  EXPECT_EQ(ofSpacing({1.0, 1.0, 5.0}, {9, 9, 1}), 0.0); // an image has no other slice
}

TEST(GradientSmoothing, keepsRangeAndValidityOfItsVolume) {
  Grid grid;
  grid.dims = {9, 9, 9};
  std::vector<float> voxels(729, 1.0f);
  voxels[0] = 5.0f;
  voxels[364] = std::numeric_limits<float>::quiet_NaN();
  const auto volume =
      std::make_shared<const Volume>(grid, voxels, Rescale{2.0, 3.0}, std::nullopt, VolumeInfo{});
  const auto smoothed = smoothedVolume(volume, 1.0);
  EXPECT_EQ(smoothed->range(), volume->range());
  EXPECT_EQ(smoothed->invalidVoxels(), 1u);
  EXPECT_TRUE(smoothed->invalidMask()[364]);
  EXPECT_TRUE(smoothed->storedCounts().counts.empty());
  EXPECT_GT(largestGradient(*smoothed), 0.0);
  EXPECT_LT(largestGradient(*smoothed), largestGradient(*volume));
}

TEST(GradientSmoothing, isTheSameOnAnyNumberOfThreadsAndGoesOnWhereItWasCancelled) {
  const auto volume = noiseOf({300, 170, 40}, {1.0, 1.0, 2.0});
  const auto alone = smoothedVolume(volume, 2.0, {1, {}, {}});
  const auto together = smoothedVolume(volume, 2.0, {8, {}, {}});
  EXPECT_EQ(alone->stored(), together->stored());
  Smoothing smoothing(volume, 2.0);
  int asked = 0, cancelled = 0;
  double last = 0.0;
  while (last < 1.0)
    try {
      const double done = smoothing.more({2, [&] { return ++asked % 7 == 0; }, {}});
      EXPECT_GT(done, last);
      last = done;
    } catch (const Cancelled&) {
      ++cancelled;
      EXPECT_EQ(smoothing.smoothed(), nullptr);
    }
  EXPECT_GT(cancelled, 3);
  EXPECT_EQ(smoothing.smoothed()->stored(), alone->stored());
}

} // namespace
} // namespace limn
