// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/Gradient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace limn {
namespace {

// f = 2x + 3y - 5z in millimetres on an anisotropic grid.
Volume linearField(const glm::ivec3& dims, const glm::dvec3& spacing) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = spacing;
  std::vector<double> voxels;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        voxels.push_back(2.0 * i * spacing.x + 3.0 * j * spacing.y - 5.0 * k * spacing.z);
  return Volume(grid, voxels, {}, {}, {});
}

TEST(Gradient, ofALinearFieldIsItsSlopeEverywhereIncludingTheBorder) {
  const Volume volume = linearField({4, 5, 3}, {0.3, 0.3, 5.0});
  for (const glm::ivec3& index : {glm::ivec3(0, 0, 0), glm::ivec3(3, 4, 2), glm::ivec3(1, 2, 1)}) {
    const glm::dvec3 g = gradientAtVoxel(volume, index);
    EXPECT_NEAR(glm::length(g - glm::dvec3(2, 3, -5)), 0.0, 1e-10);
  }
  EXPECT_NEAR(glm::length(gradientAt(volume, {-0.5, 2.25, 2.5}) - glm::dvec3(2, 3, -5)), 0.0, 1e-10);
  EXPECT_NEAR(largestGradient(volume), std::sqrt(38.0), 1e-10);
}

TEST(Gradient, isZeroAlongAnAxisOfOneVoxel) {
  EXPECT_EQ(gradientAtVoxel(linearField({4, 1, 3}, {1, 1, 1}), {1, 0, 1}).y, 0.0);
}

TEST(Gradient, turnsWithTheDirectionOfTheGrid) {
  Grid grid;
  grid.dims = {3, 3, 3};
  grid.direction = glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  std::vector<float> voxels;
  for (int n = 0; n < 27; ++n)
    voxels.push_back(static_cast<float>(n % 3));
  EXPECT_NEAR(gradientAtVoxel(Volume(grid, voxels, {}, {}, {}), {1, 1, 1}).y, 1.0, 1e-12);
}

TEST(Gradient, percentileIsTheNearestRank) {
  // Moduli of a ramp of squares 0,1,4,9,16 with one-sided ends: 1, 2, 4, 6, 7.
  Grid grid;
  grid.dims = {5, 1, 1};
  const Volume volume(grid, std::vector<float>{0, 1, 4, 9, 16}, {}, {}, {});
  EXPECT_NEAR(gradientPercentile(volume, 50.0), 4.0, 1e-6);
  EXPECT_NEAR(gradientPercentile(volume, 60.1), 6.0, 1e-6);
  EXPECT_NEAR(gradientPercentile(volume, 100.0), 7.0, 1e-6);
}

TEST(Gradient, percentilesAreThoseOfTheSortedModuli) {
  Grid grid;
  grid.dims = {23, 17, 11};
  grid.spacingMm = {0.5, 1.0, 2.5};
  std::mt19937 generator(3);
  std::vector<float> voxels(23 * 17 * 11);
  for (float& voxel : voxels)
    voxel = static_cast<float>(generator() % 3000) * (generator() % 7 == 0 ? 0.0f : 1.0f);
  const Volume volume(grid, voxels, {}, std::nullopt, {});
  std::vector<float> moduli;
  for (int k = 0; k < 11; ++k)
    for (int j = 0; j < 17; ++j)
      for (int i = 0; i < 23; ++i)
        moduli.push_back(static_cast<float>(glm::length(gradientAtVoxel(volume, {i, j, k}))));
  std::sort(moduli.begin(), moduli.end());
  for (const double percent : {0.001, 1.0, 12.5, 50.0, 90.0, 99.5, 99.999}) {
    const auto rank =
        static_cast<std::size_t>(std::ceil(percent / 100.0 * static_cast<double>(moduli.size())));
    EXPECT_EQ(gradientPercentile(volume, percent), moduli[rank - 1]) << percent;
  }
  EXPECT_EQ(static_cast<float>(largestGradient(volume)), moduli.back());
  EXPECT_EQ(gradientPercentile(volume, 100.0), largestGradient(volume)) << "not rounded";
}

TEST(Gradient, leavesOutVoxelsWhoseStencilTouchesAnInvalidOne) {
  Grid grid;
  grid.dims = {5, 1, 1};
  const Volume volume(grid, std::vector<std::int16_t>{0, 1, 2, 3, -2000}, {}, PaddingRange{-2000, -2000}, {});
  EXPECT_NEAR(largestGradient(volume), 1.0, 1e-12);
}

} // namespace
} // namespace limn
