// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Error.h"
#include "scene/presets/Suggestion.h"
#include "scene/volume/Histogram.h"
#include "scene/volume/Phantom.h"
#include "support/Heads.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>

// Where materials touch, and the bands proposed for it.

namespace limn {
namespace {

void print(const std::vector<Boundary>& boundaries) {
  for (const Boundary& boundary : boundaries)
    std::printf("%8.1f | %8.1f at %8.1f, %4.1f %%\n", boundary.low, boundary.high, boundary.value(),
                100.0 * boundary.share);
}

// Half-way between every two materials of the phantom, whose parts are known by formula.
std::set<double> middlesOfMaterials() {
  std::set<double> materials{-1000.0};
  for (const PhantomPart& part : phantomParts())
    materials.insert(part.hu);
  std::set<double> middles;
  for (const double low : materials)
    for (const double high : materials)
      if (low < high)
        middles.insert((low + high) / 2.0);
  return middles;
}

double distanceTo(const std::set<double>& values, double value) {
  double least = 1e9;
  for (const double other : values)
    least = std::min(least, std::abs(other - value));
  return least;
}

std::set<double> valuesOf(const std::vector<Boundary>& boundaries) {
  std::set<double> values;
  for (const Boundary& boundary : boundaries)
    values.insert(boundary.value());
  return values;
}

// Air and skin, fat and muscle, muscle and the skull, its diploe.
constexpr double largeSurfaces[] = {(-1000.0 + 20.0) / 2, (-100.0 + 50.0) / 2, (50.0 + 1200.0) / 2,
                                    (450.0 + 1200.0) / 2};

// The shells of the skull are 2 mm thick, their edges 1.5 mm: voxels of 0.75 mm see what lies between.
TEST(Boundaries, ofThePhantomAreHalfWayBetweenItsMaterials) {
  const auto volume = phantomVolume({.spacingMm = 0.75});
  const double bin = binWidth(histogramOf(*volume));
  const std::vector<Boundary> boundaries = boundariesOf(*volume);
  print(boundaries);
  for (const Boundary& boundary : boundaries)
    EXPECT_LE(distanceTo(middlesOfMaterials(), boundary.value()), bin) << boundary.value();
  const std::set<double> found = valuesOf(boundaries);
  for (const double large : largeSurfaces)
    EXPECT_LE(distanceTo(found, large), bin) << large;
}

TEST(Boundaries, areFoundThroughNoise) {
  const std::vector<Boundary> boundaries = boundariesOf(*phantomVolume({.spacingMm = 1.0, .noiseHu = 20.0}));
  print(boundaries);
  // None of noise alone: two values closer than four standard deviations.
  for (const Boundary& boundary : boundaries)
    EXPECT_GT(boundary.high - boundary.low, 80.0);
  // A standard deviation of noise moves the ends of a profile, which are its highest and lowest values
  // nearby.
  const std::set<double> found = valuesOf(boundaries);
  for (const double large : largeSurfaces)
    EXPECT_LE(distanceTo(found, large), 20.0) << large;
}

TEST(Boundaries, areTheSameOnAnyNumberOfThreads) {
  const auto volume = phantomVolume({.spacingMm = 3.0, .noiseHu = 20.0});
  EXPECT_EQ(boundariesOf(*volume, {1, {}, {}}), boundariesOf(*volume, {3, {}, {}}));
}

TEST(Boundaries, ofTheCtHeadAreSkinAndBone) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  const std::vector<Boundary> boundaries = boundariesOf(*test::ctHead());
  print(boundaries);
  const auto isSkin = [](const Boundary& b) { return b.low < -900.0 && b.high > -150.0 && b.high < 150.0; };
  const auto isBone = [](const Boundary& b) { return b.low > -150.0 && b.low < 150.0 && b.high > 400.0; };
  EXPECT_TRUE(std::ranges::any_of(boundaries, isSkin));
  EXPECT_TRUE(std::ranges::any_of(boundaries, isBone));
}

std::shared_ptr<const Volume> volumeOf(const glm::ivec3& dims, const std::function<double(int)>& valueAtX) {
  Grid grid;
  grid.dims = dims;
  std::vector<float> voxels;
  for (int n = 0; n < dims.x * dims.y * dims.z; ++n)
    voxels.push_back(static_cast<float>(valueAtX(n % dims.x)));
  return std::make_shared<const Volume>(grid, std::move(voxels), Rescale{}, std::nullopt, VolumeInfo{});
}

TEST(Boundaries, ofHardVolumes) {
  EXPECT_TRUE(boundariesOf(*volumeOf({8, 8, 8}, [](int) { return 7.0; })).empty()) << "constant";
  EXPECT_TRUE(boundariesOf(*volumeOf({1, 1, 1}, [](int) { return 7.0; })).empty()) << "one voxel";
  // Two values: the one boundary, exactly.
  const std::vector<Boundary> two =
      boundariesOf(*volumeOf({8, 8, 8}, [](int x) { return x < 4 ? -1.0 : 3.0; }));
  ASSERT_EQ(two.size(), 1u);
  EXPECT_EQ(two[0], (Boundary{-1.0, 3.0, 1.0}));
  EXPECT_EQ(boundariesOf(*volumeOf({8, 1, 1}, [](int x) { return x < 4 ? 0.0 : 1.0; })).size(), 1u)
      << "a row";
  // A ramp from end to end changes everywhere alike; that it is one boundary is as good an answer as none.
  EXPECT_LE(boundariesOf(*volumeOf({64, 4, 4}, [](int x) { return 1.0 * x; })).size(), 64u);
}

TEST(Boundaries, canBeCancelled) {
  const auto volume = phantomVolume({.spacingMm = 3.0});
  EXPECT_THROW(boundariesOf(*volume, {1, [] { return true; }, {}}), Cancelled);
}

TEST(LowHighHistogram, toldTwoGroupsApart) {
  std::vector<LowAndHigh> places;
  for (int n = 0; n < 300; ++n)
    places.push_back({(n % 30) / 10.0 - 1.45, 100.0 + (n % 50) / 10.0 - 2.45});
  for (int n = 0; n < 100; ++n)
    places.push_back({100.0, 200.0});
  const std::vector<LowHighPeak> peaks = peaksOf(places);
  ASSERT_EQ(peaks.size(), 2u);
  EXPECT_NEAR(peaks[0].at.low, 0.0, 1.0);
  EXPECT_NEAR(peaks[0].at.high, 100.0, 1.0) << "a bin is 0.8 wide";
  EXPECT_DOUBLE_EQ(peaks[0].share, 0.75);
  EXPECT_EQ(peaks[1].at, (LowAndHigh{100.0, 200.0}));
  EXPECT_TRUE(peaksOf({}).empty());
}

TEST(Suggestion, bandsLieAroundTheirBoundariesAndGrowMoreOpaque) {
  const std::vector<Suggestion> bands =
      suggestionsFor({{0.0, 1000.0, 0.6}, {-1000.0, 0.0, 0.3}, {40.0, 50.0, 0.1}}, {-1000.0, 3000.0});
  ASSERT_EQ(bands.size(), 2u) << "a step of 10 over a tenth of all boundaries is too little";
  EXPECT_EQ(bands[1].top.value, -500.0) << "the less prominent";
  EXPECT_EQ(bands[1].from.value, -750.0) << "a quarter of the way between the two materials";
  EXPECT_EQ(bands[1].to.value, -250.0);
  EXPECT_EQ(bands[1].to.opacity, 0.0);
  EXPECT_LT(bands[1].top.opacity, bands[0].top.opacity);
  EXPECT_EQ(bands[0].to.value, 3000.0) << "nothing lies above the last";
  EXPECT_EQ(bands[0].to.opacity, bands[0].top.opacity);
}

TEST(Suggestion, aBandShowsWhereItIsTheMoreOpaqueAndLowersNothing) {
  const Suggestion band = suggestionsFor({{-1000.0, 0.0, 1.0}, {0.0, 1000.0, 0.5}}, {-2000.0, 2000.0})[0];
  ASSERT_EQ(band.top.value, -500.0);
  const TransferFunction shown{1.0, {band.from, band.top, band.to}};
  const TransferFunction bone{1.0,
                              {{-600.0, {0, 0, 1}, 0.0}, {0.0, {0, 1, 0}, 0.6}, {2000.0, {1, 0, 0}, 0.9}}};
  const TransferFunction flat{1.0, {{-2000.0, {0, 0, 1}, 0.05}, {2000.0, {0, 0, 1}, 0.05}}};
  const TransferFunction step{1.0, {{-450.0, {0, 0, 1}, 0.0}, {-450.0, {0, 1, 0}, 0.1}}};
  for (const TransferFunction& before : {bone, flat, step}) {
    const TransferFunction after = withBand(before, band);
    EXPECT_EQ(normalised(after), after) << "ascending";
    for (double value = -1999.0; value < 2000.0; value += 7.0) {
      const bool isWithin = value > band.from.value && value < band.to.value;
      const double expected =
          std::max(classify(before, value).opacity, isWithin ? classify(shown, value).opacity : 0.0);
      EXPECT_NEAR(classify(after, value).opacity, expected, 1e-9) << value;
      EXPECT_NEAR(classify(withBand(after, band), value).opacity, expected, 1e-9) << "twice is once";
    }
    EXPECT_EQ(classify(after, -500.0).color, band.top.color);
    EXPECT_EQ(classify(after, 1500.0).color, classify(before, 1500.0).color);
  }
  EXPECT_EQ(withBand({1.0, {}}, band).points, (std::vector{band.from, band.top, band.to}));
  const TransferFunction opaque{1.0, {{-2000.0, {1, 1, 1}, 1.0}, {2000.0, {1, 1, 1}, 1.0}}};
  EXPECT_EQ(withBand(opaque, band), opaque) << "nothing to add";
}

} // namespace
} // namespace limn
