// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/framing/KeptVoxels.h"
#include "scene/presets/Suggestion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace limn {
namespace {

// 10 × 8 × 6 voxels whose value is the index along x.
std::shared_ptr<const Volume> steps() {
  Grid grid;
  grid.dims = {10, 8, 6};
  std::vector<std::int16_t> stored;
  for (int voxel = 0; voxel < 10 * 8 * 6; ++voxel)
    stored.push_back(static_cast<std::int16_t>(voxel % 10));
  return std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
}

// Keeps what lies before a plane along z.
Region lowerPart(const glm::ivec3& dims, int below) {
  std::vector<std::uint8_t> places;
  for (int k = 0; k < dims.z; ++k)
    places.insert(places.end(), static_cast<std::size_t>(dims.x) * dims.y, k < below ? 1 : 0);
  return bodyRegion(dims, places);
}

std::uint64_t sumOf(const Histogram& histogram) {
  return std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0});
}

TEST(KeptVoxels, areAllWhereNothingIsHidden) {
  const auto volume = steps();
  const KeptVoxels all(volume->grid(), {}, {});
  EXPECT_TRUE(all.areAll());
  EXPECT_TRUE(all.has(9, 7, 5));
  EXPECT_EQ(histogramOfKept(*volume, all), histogramOf(*volume));
  EXPECT_TRUE(KeptVoxels(volume->grid(), lowerPart(volume->grid().dims, 6), {}).has(0, 0, 5));
}

TEST(KeptVoxels, haveTheirCentresInTheCropAndAWeightAboveNothing) {
  const auto volume = steps();
  // Half of x: the box fills -0.5 to 9.5, so that its middle is 4.5 and the voxels 0 to 4 lie before it.
  const CropBox crop{{0.0, 0.0, 0.0}, {0.5, 1.0, 1.0}};
  Region keep = lowerPart(volume->grid().dims, 2);
  const KeptVoxels kept(volume->grid(), keep, crop);
  EXPECT_FALSE(kept.areAll());
  EXPECT_TRUE(kept.has(4, 7, 1));
  EXPECT_FALSE(kept.has(5, 7, 1));
  EXPECT_FALSE(kept.has(4, 7, 2));
  keep.weights = {0.1, 1.0}; // a label that is faint still shows
  EXPECT_TRUE(KeptVoxels(volume->grid(), keep, crop).has(4, 7, 2));
}

TEST(KeptVoxels, areCountedInTheBinsOfTheWholeVolume) {
  const auto volume = steps();
  const CropBox crop{{0.0, 0.0, 0.0}, {0.5, 1.0, 1.0}};
  const KeptVoxels kept(volume->grid(), lowerPart(volume->grid().dims, 2), crop);
  const Histogram histogram = histogramOfKept(*volume, kept);
  EXPECT_EQ(histogram.range, histogramOf(*volume).range);
  ASSERT_EQ(histogram.counts.size(), 10u);
  for (std::size_t value = 0; value < 10; ++value)
    EXPECT_EQ(histogram.counts[value], value < 5 ? 8u * 2u : 0u);
}

TEST(KeptVoxels, whatACurveShowsOfThemHasOpacity) {
  const Histogram whole = histogramOf(*steps());
  const TransferFunction function{1.0, {{3.0, {}, 0.0}, {5.0, {}, 0.5}, {5.0, {}, 0.0}}};
  const Histogram shown = shownBy(function, whole);
  // Above 3 and up to 5; the bin of a value reaches half a value to both sides.
  for (std::size_t value = 0; value < 10; ++value)
    EXPECT_EQ(shown.counts[value], value >= 3 && value <= 5 ? 48u : 0u) << value;
  EXPECT_EQ(sumOf(shownBy({}, whole)), 0u);
}

TEST(KeptVoxels, ofARangeBinsAreEmptyThatLieOutside) {
  const Histogram whole = histogramOf(*steps());
  const Histogram held = heldWithin(whole, 3.0, 5.2);
  for (std::size_t value = 0; value < 10; ++value) // a bin reaches half a value to both sides
    EXPECT_EQ(held.counts[value], value >= 3 && value <= 5 ? whole.counts[value] : 0u) << value;
}

// A ball of 1000 beside a plate of 3000, in 0.
std::shared_ptr<const Volume> ballAndPlate(const glm::ivec3& dims) {
  Grid grid;
  grid.dims = dims;
  std::vector<float> stored;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) {
        const double away = glm::length(glm::dvec3(i, j, k) - glm::dvec3(20.0, 20.0, 16.0));
        const double ball = 1000.0 * std::clamp((10.0 - away) / 2.0 + 0.5, 0.0, 1.0);
        const double plate = 3000.0 * std::clamp((3.0 - std::abs(k - 40.0)) / 2.0 + 0.5, 0.0, 1.0);
        stored.push_back(static_cast<float>(ball + plate));
      }
  return std::make_shared<const Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
}

TEST(KeptVoxels, aloneTellBoundaries) {
  const auto volume = ballAndPlate({40, 40, 56});
  const auto hasPlate = [](const std::vector<Boundary>& boundaries) {
    return std::ranges::any_of(boundaries, [](const Boundary& one) { return one.high > 2500.0; });
  };
  const auto hasBall = [](const std::vector<Boundary>& boundaries) {
    return std::ranges::any_of(boundaries,
                               [](const Boundary& one) { return std::abs(one.value() - 500.0) < 50.0; });
  };
  const std::vector<Boundary> whole = boundariesOf(*volume);
  EXPECT_TRUE(hasPlate(whole));
  EXPECT_TRUE(hasBall(whole));
  const Grid& grid = volume->grid();
  const std::vector<Boundary> inRegion =
      boundariesOf(*volume, KeptVoxels(grid, lowerPart(grid.dims, 30), {}));
  EXPECT_FALSE(hasPlate(inRegion)) << "the table is hidden";
  EXPECT_TRUE(hasBall(inRegion));
  const std::vector<Boundary> inCrop =
      boundariesOf(*volume, KeptVoxels(grid, {}, {{0.0, 0.0, 0.55}, {1.0, 1.0, 1.0}}));
  EXPECT_TRUE(hasPlate(inCrop));
  EXPECT_FALSE(hasBall(inCrop));
  EXPECT_TRUE(boundariesOf(*volume, KeptVoxels(grid, lowerPart(grid.dims, 0), {})).empty());
}

} // namespace
} // namespace limn
