// SPDX-License-Identifier: GPL-3.0-or-later
// What is found by looking at few moduli is what sorting all of them finds, to the bit.
#include "scene/light/ModulusSearch.h"
#include "scene/basics/Error.h"
#include "scene/light/Gradient.h"
#include "scene/volume/Histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace limn {
namespace {

// More voxels than a search looks at one by one.
constexpr glm::ivec3 manyVoxels{131, 90, 67};

Grid stretchedGrid(const glm::ivec3& dims) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {0.4, 0.7, 1.1};
  return grid;
}

template <class T, class Function>
Volume stretched(const glm::ivec3& dims, Function&& valueAt, const Rescale& rescale = {},
                 std::optional<PaddingRange> padding = {}, const Effort& effort = {}) {
  std::vector<T> voxels;
  voxels.reserve(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        voxels.push_back(static_cast<T>(valueAt(i, j, k)));
  return Volume(stretchedGrid(dims), std::move(voxels), rescale, padding, {}, effort);
}

// The definition: of every voxel that is valid with its neighbours. In units of a power of two, so that
// squares are numbers.
std::vector<double> sortedModuli(const Volume& volume) {
  const glm::ivec3 dims = volume.grid().dims;
  const auto isInvalid = [&](const glm::ivec3& at) {
    return glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, dims)) &&
           volume.invalidMask()[voxelOffset(dims, at.x, at.y, at.z)];
  };
  std::vector<double> moduli;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) {
        bool isEligible = true;
        if (!volume.invalidMask().empty())
          for (const glm::ivec3& step :
               {glm::ivec3(0), glm::ivec3(1, 0, 0), glm::ivec3(0, 1, 0), glm::ivec3(0, 0, 1)})
            isEligible = isEligible && !isInvalid(glm::ivec3(i, j, k) + step) &&
                         !isInvalid(glm::ivec3(i, j, k) - step);
        if (isEligible)
          moduli.push_back(glm::length(gradientAtVoxel(volume, {i, j, k}) / modulusUnit(volume)));
      }
  std::sort(moduli.begin(), moduli.end());
  return moduli;
}

void expectFindsWhatSortingFinds(const Volume& volume, const std::string& what) {
  const std::vector<double> moduli = sortedModuli(volume);
  const double unit = modulusUnit(volume);
  for (const int threads : {1, 2, 5})
    EXPECT_EQ(findModuli(volume, std::nullopt, {threads, {}, {}}).largest, unit * moduli.back()) << what;
  for (const double percent : {0.001, 37.0, 90.0, 99.5, 99.9999, 100.0}) {
    const auto rank =
        static_cast<std::size_t>(std::ceil(percent / 100.0 * static_cast<double>(moduli.size())));
    const double expected = percent < 100.0 ? static_cast<float>(moduli[rank - 1]) : moduli.back();
    for (const int threads : {1, 3}) {
      const FoundModuli found = findModuli(volume, percent, {threads, {}, {}});
      EXPECT_EQ(found.percentile, unit * expected) << what << ' ' << percent;
      EXPECT_EQ(found.largest, unit * moduli.back()) << what << ' ' << percent;
    }
  }
}

int hashed(int i, int j, int k) {
  return static_cast<int>((static_cast<unsigned>(i) * 73856093u ^ static_cast<unsigned>(j) * 19349663u ^
                           static_cast<unsigned>(k) * 83492791u) %
                          1009u);
}

TEST(ModulusSearch, findsWhatSortingFindsInEveryType) {
  const auto smooth = [](int i, int j, int k) {
    return 60.0 + 50.0 * std::sin(0.1 * i) * std::cos(0.07 * (j + k));
  };
  expectFindsWhatSortingFinds(stretched<std::uint8_t>(manyVoxels, smooth), "uint8");
  expectFindsWhatSortingFinds(stretched<std::int8_t>(manyVoxels, smooth, {2.5, 1.0}), "int8");
  expectFindsWhatSortingFinds(stretched<std::int16_t>(manyVoxels, hashed, {-1.5, 7.0}), "int16");
  expectFindsWhatSortingFinds(
      stretched<std::uint16_t>(manyVoxels, [](int i, int j, int k) { return 64 * hashed(i, j, k); }),
      "uint16");
  expectFindsWhatSortingFinds(stretched<float>(manyVoxels, smooth), "float32");
  expectFindsWhatSortingFinds(stretched<std::int32_t>({40, 30, 20}, hashed), "int32");
  expectFindsWhatSortingFinds(stretched<double>({40, 30, 20}, smooth), "float64");
}

// A sample of a few voxels in a hundred thousand misses what one voxel has.
TEST(ModulusSearch, findsWhatNoSampleShows) {
  const auto spike = [](int i, int j, int k) { return i == 77 && j == 41 && k == 66 ? 30000 : 0; };
  expectFindsWhatSortingFinds(stretched<std::int16_t>(manyVoxels, spike), "one voxel");
  const auto ramp = [](int i, int, int) { return 7 * i; };
  expectFindsWhatSortingFinds(stretched<std::int16_t>(manyVoxels, ramp), "all alike");
  const auto steps = [](int i, int, int) { return i / 64 * 100; };
  expectFindsWhatSortingFinds(stretched<std::uint8_t>(manyVoxels, steps), "nearly all zero");
}

TEST(ModulusSearch, keepsItsDigitsWhereFloatsHaveNone) {
  for (const double unit : {1e-300, 1e-42, 1e-30, 1e30, 1e290}) {
    const auto tiny = [unit](int i, int j, int k) { return unit * hashed(i, j, k); };
    expectFindsWhatSortingFinds(stretched<double>({30, 20, 10}, tiny), std::to_string(std::log10(unit)));
  }
  // Differences far below the volume's range: their squares vanish in float.
  const auto faint = [](int i, int, int k) { return k == 0 && i == 0 ? 1e15 : 1e-9 * i; };
  expectFindsWhatSortingFinds(stretched<double>({200, 60, 60}, faint), "faint");
}

TEST(ModulusSearch, leavesOutWhatTouchesPaddingInEveryPlaceOfARow) {
  const auto padded = [](int i, int j, int k) { return hashed(i, j, k) % 97 == 0 ? -2000 : hashed(i, k, j); };
  for (const glm::ivec3& dims : {glm::ivec3(1, 1, 400), glm::ivec3(64, 9, 5), glm::ivec3(65, 9, 5),
                                 glm::ivec3(127, 9, 5), manyVoxels}) {
    const Volume volume = stretched<std::int16_t>(dims, padded, {}, PaddingRange{-2000, -2000});
    ASSERT_FALSE(volume.invalidMask().empty());
    expectFindsWhatSortingFinds(volume, std::to_string(dims.x));
  }
  const Volume none = stretched<std::int16_t>(
      {3, 1, 1}, [](int i, int, int) { return i == 1 ? -5 : 2; }, {}, PaddingRange{-5, -5});
  EXPECT_EQ(findModuli(none, 99.5).percentile, 0.0) << "no voxel is eligible";
}

// A piece of work has 65,536 voxels, so that each of these volumes is several.
TEST(ModulusSearch, isCancelledBetweenTwoPieces) {
  const Volume volume = stretched<std::int16_t>(manyVoxels, hashed);
  for (const int after : {0, 1, 40}) {
    int asked = 0;
    const Effort effort{1, [&] { return asked++ == after; }, {}};
    EXPECT_THROW(findModuli(volume, 99.5, effort), Cancelled);
    EXPECT_EQ(asked, after + 1);
  }
}

// What a volume knows of its values does not depend on who counted.
TEST(ModulusSearch, threadsChangeNothingOfAVolume) {
  const auto padded = [](int i, int j, int k) { return hashed(i, j, k) % 97 == 0 ? -2000 : hashed(i, k, j); };
  const Effort alone{1, {}, {}}, together{4, {}, {}};
  const PaddingRange padding{-2000, -2000};
  const Volume one = stretched<std::int16_t>(manyVoxels, padded, {}, padding, alone);
  const Volume four = stretched<std::int16_t>(manyVoxels, padded, {}, padding, together);
  EXPECT_EQ(one.range(), four.range());
  EXPECT_EQ(one.stored(), four.stored());
  EXPECT_EQ(one.invalidVoxels(), four.invalidVoxels());
  EXPECT_EQ(histogramOf(one), histogramOf(four));
  const Volume floats = stretched<float>(manyVoxels, padded, {}, padding, together);
  EXPECT_EQ(floats.range(), one.range());
  EXPECT_EQ(floats.invalidVoxels(), one.invalidVoxels());
  EXPECT_EQ(histogramOf(floats, 1024, alone), histogramOf(floats, 1024, together));
  int asked = 0;
  const Effort cancelled{1, [&] { return asked++ == 3; }, {}};
  EXPECT_THROW(stretched<std::int16_t>(manyVoxels, padded, {}, padding, cancelled), Cancelled);
  EXPECT_EQ(asked, 4);
}

} // namespace
} // namespace limn
