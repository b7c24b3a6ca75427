// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Pyramid.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

#include <random>

namespace limn {
namespace {

template <class T>
std::shared_ptr<const Volume> randomVolume(const glm::ivec3& dims, double lowest, double highest,
                                           unsigned seed, const Rescale& rescale = {}) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> numbers(lowest, highest);
  std::vector<T> stored(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  for (T& voxel : stored)
    voxel = static_cast<T>(numbers(random));
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {0.5, 2.0, 3.0};
  grid.originMm = {-7.0, 11.0, 13.0};
  return std::make_shared<const Volume>(grid, std::move(stored), rescale, std::nullopt, VolumeInfo{});
}

double widthOf(const Volume& volume) {
  return volume.range().highest - volume.range().lowest;
}

// Of both fields at a place, as a share of the whole one's range.
double differenceAt(const Volume& whole, const Volume& coarse, const glm::dvec3& index) {
  const glm::dvec3 there = worldToIndex(coarse.grid(), indexToWorld(whole.grid(), index));
  return std::abs(valueAt(whole, index) - valueAt(coarse, there)) / widthOf(whole);
}

// Where centres of voxels of either volume cross.
std::vector<double> centresAlong(const Volume& whole, const Volume& coarse, int axis) {
  std::vector<double> centres;
  const double each = static_cast<double>(whole.grid().dims[axis]) / coarse.grid().dims[axis];
  for (int i = 0; i < whole.grid().dims[axis]; ++i)
    centres.push_back(i);
  for (int i = 0; i < coarse.grid().dims[axis]; ++i)
    centres.push_back((i + 0.5) * each - 0.5);
  return centres;
}

double largestDifference(const Volume& whole, const Volume& coarse) {
  double largest = 0.0;
  for (const double z : centresAlong(whole, coarse, 2))
    for (const double y : centresAlong(whole, coarse, 1))
      for (const double x : centresAlong(whole, coarse, 0))
        largest = std::max(largest, differenceAt(whole, coarse, {x, y, z}));
  return largest;
}

void expectItsErrorIsTrue(const Volume& whole, const CoarseVolume& level, unsigned seed) {
  const double found = largestDifference(whole, *level.volume);
  EXPECT_LE(found, level.largestError);
  EXPECT_GT(found, level.largestError - 1e-5) << "a bound so loose tells nothing";
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shares(0.0, 1.0);
  for (int n = 0; n < 2000; ++n) {
    const glm::dvec3 share(shares(random), shares(random), shares(random));
    const glm::dvec3 index = share * glm::dvec3(whole.grid().dims) - 0.5;
    ASSERT_LE(differenceAt(whole, *level.volume, index), level.largestError) << "between the voxels";
  }
}

constexpr std::uint64_t boundless = std::uint64_t{1} << 40;

TEST(Pyramid, itsLevelsNeverLieFartherFromTheFieldThanTheySay) {
  const glm::ivec3 sizes[] = {{16, 16, 16}, {17, 9, 13}, {1, 31, 8}, {33, 1, 1}, {3, 2, 5}, {40, 7, 19}};
  unsigned seed = 0;
  for (const glm::ivec3& dims : sizes) {
    SCOPED_TRACE(testing::Message() << dims.x << " " << dims.y << " " << dims.z);
    const std::shared_ptr<const Volume> volumes[] = {
        randomVolume<std::uint8_t>(dims, 0.0, 255.0, ++seed),
        randomVolume<std::int16_t>(dims, -32768.0, 32767.0, ++seed, {-0.5, 100.0}),
        randomVolume<std::uint16_t>(dims, 60000.0, 60009.0, ++seed),
        randomVolume<float>(dims, -1e-3, 2e-3, ++seed, {3.0, 0.0}),
        randomVolume<double>(dims, 1e6, 1e6 + 1.0, ++seed)};
    for (const auto& volume : volumes)
      for (const CoarseVolume& level : pyramidOf(*volume, boundless)) {
        SCOPED_TRACE(testing::Message() << voxelTypeName(volume->stored()) << " by " << level.reduction);
        expectItsErrorIsTrue(*volume, level, ++seed);
      }
  }
}

TEST(Pyramid, takesTheMeanAndFillsTheSameBox) {
  const auto volume = randomVolume<float>({4, 2, 2}, 0.0, 1.0, 1);
  const std::vector<CoarseVolume> levels = pyramidOf(*volume, boundless);
  ASSERT_EQ(levels.size(), 3u);
  EXPECT_EQ(levels[0].reduction, 2);
  EXPECT_EQ(levels[1].reduction, 4);
  EXPECT_EQ(levels[2].reduction, 8);
  const Volume& half = *levels[0].volume;
  ASSERT_EQ(half.grid().dims, glm::ivec3(2, 1, 1));
  double sum = 0.0;
  for (int n = 0; n < 8; ++n)
    sum += volume->value({n % 2, n / 2 % 2, n / 4});
  EXPECT_NEAR(half.value({0, 0, 0}), sum / 8.0, 1e-6);

  const auto odd = randomVolume<std::uint8_t>({7, 5, 3}, 0.0, 255.0, 2);
  for (const CoarseVolume& level : pyramidOf(*odd, boundless)) {
    EXPECT_EQ(voxelTypeName(level.volume->stored()), "uint8");
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(boxSizeMm(level.volume->grid())[axis], boxSizeMm(odd->grid())[axis], 1e-9);
      EXPECT_NEAR(boxCentreMm(level.volume->grid())[axis], boxCentreMm(odd->grid())[axis], 1e-9);
    }
  }
}

TEST(Pyramid, hasOnlyLevelsThatHaveRoomAndAlwaysOne) {
  const auto volume = randomVolume<std::int16_t>({64, 64, 64}, 0.0, 1000.0, 3);
  const auto reductions = [&](std::uint64_t mostBytes) {
    std::vector<int> found;
    for (const CoarseVolume& level : pyramidOf(*volume, mostBytes))
      found.push_back(level.reduction);
    return found;
  };
  EXPECT_EQ(reductions(2 * 32 * 32 * 32), (std::vector<int>{2, 4, 8}));
  EXPECT_EQ(reductions(2 * 32 * 32 * 32 - 1), (std::vector<int>{4, 8}));
  EXPECT_EQ(reductions(2 * 4 * 4 * 4), (std::vector<int>{16}));
  EXPECT_EQ(reductions(1), (std::vector<int>{64})) << "one voxel is the least";
}

// Slices come in slabs, here of 32: what lies where two of them meet is compared, too.
TEST(Pyramid, comparesEverySlice) {
  const glm::ivec3 dims(256, 256, 50);
  Grid grid;
  grid.dims = dims;
  for (const int slice : {0, 29, 31, 32, 33, 48, 49}) {
    std::vector<std::uint8_t> stored(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
    stored[voxelOffset(dims, 100, 101, slice)] = 200;
    const Volume volume(grid, std::move(stored), {}, std::nullopt, {});
    for (const CoarseVolume& level : pyramidOf(volume, boundless)) {
      const double there = differenceAt(volume, *level.volume, {100, 101, slice});
      EXPECT_GT(there, 0.5) << "a mean hardly shows one voxel";
      EXPECT_NEAR(level.largestError, there, 1e-5) << slice << " by " << level.reduction;
    }
  }
}

TEST(Pyramid, oneOfOneValueHasNoErrorToSpeakOf) {
  Grid grid;
  grid.dims = {19, 18, 17};
  const Volume volume(grid, std::vector<std::uint16_t>(19 * 18 * 17, 7), {}, std::nullopt, {});
  for (const CoarseVolume& level : pyramidOf(volume, boundless))
    EXPECT_EQ(level.largestError, 0.0);
}

TEST(Pyramid, tellsHowFarItIsAndEndsWhenToldTo) {
  const auto volume = randomVolume<std::int16_t>({80, 80, 80}, 0.0, 1000.0, 4);
  std::vector<double> told;
  pyramidOf(*volume, boundless, {2, {}, [&](double fraction) { told.push_back(fraction); }});
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_DOUBLE_EQ(told.back(), 1.0);
  EXPECT_THROW(pyramidOf(*volume, boundless, {2, [] { return true; }, {}}), Cancelled);
}

} // namespace
} // namespace limn
