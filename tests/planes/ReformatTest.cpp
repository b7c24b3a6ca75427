// SPDX-License-Identifier: GPL-3.0-or-later
#include "Definition.h"

#include "scene/basics/Error.h"
#include "scene/volume/Phantom.h"
#include "support/JudgedTime.h"

#include <gtest/gtest.h>

#include <chrono>

namespace limn {
namespace {

using test::coveringPlane;
using test::expectDefined;
using test::noiseOf;
using test::plainGrid;
using test::turnedGrid;

constexpr Slab::Mode modes[] = {Slab::Mode::mean, Slab::Mode::maximum};

// All planes and samplings through a place.
void expectAllDefined(const Volume& volume, const glm::dvec3& throughMm) {
  for (const PatientPlane plane : patientPlanes)
    for (const PlaneInterpolation interpolation : planeInterpolations) {
      const PlaneGrid covering = coveringPlane(volume.grid(), plane, throughMm);
      SCOPED_TRACE(std::string(nameOf(plane)) + " " + nameOf(interpolation));
      expectDefined(volume, covering, {interpolation, {}});
      for (const Slab::Mode mode : modes)
        expectDefined(volume, covering, {interpolation, {mode, 7.3}});
    }
}

TEST(Reformat, ofThePhantomIsItsDefinition) {
  const auto phantom = phantomVolume({.spacingMm = 6.0});
  expectAllDefined(*phantom, {5.1, -3.7, 11.9});
}

TEST(Reformat, ofObliqueVolumesIsItsDefinition) {
  for (const double degrees : {7.7, 45.0, 100.0}) {
    SCOPED_TRACE(degrees);
    const Volume volume =
        noiseOf(turnedGrid({17, 12, 9}, {0.8, 1.1, 2.3}, degrees, {0.3, 1.0, -0.7}), {2.0, -50.0});
    expectAllDefined(volume, boxCentreMm(volume.grid()) + glm::dvec3(0.4, -0.9, 1.7));
  }
}

TEST(Reformat, ofALeftHandedGridIsItsDefinition) {
  Grid grid = turnedGrid({11, 9, 7}, {1.0, 1.0, 1.5}, 20.0, {1.0, 1.0, 0.0});
  grid.direction[2] = -grid.direction[2];
  expectAllDefined(noiseOf(grid, {-1.5, 3.0}), boxCentreMm(grid));
}

TEST(Reformat, ofOneAndTwoSlicesHasTheirThickness) {
  for (const int slices : {1, 2}) {
    const Volume volume = noiseOf(plainGrid({6, 5, slices}, {1.0, 1.0, 4.0}));
    expectAllDefined(volume, middleVoxelMm(volume.grid()));
    const PlaneGrid coronal = coveringPlane(volume.grid(), PatientPlane::coronal, {0.0, 2.0, 0.0});
    EXPECT_EQ(coronal.size.y, 4 * slices) << "pixels of 1 mm";
    const PlaneImage image = reformatted(volume, coronal, {});
    for (const double value : image.values)
      EXPECT_FALSE(std::isnan(value)) << "every pixel lies in the volume";
  }
}

TEST(Reformat, ofOblongPixelsHasTheirShape) {
  const Volume volume = noiseOf(plainGrid({8, 8, 3}, {0.5, 2.0, 3.0}));
  expectAllDefined(volume, middleVoxelMm(volume.grid()));
  EXPECT_EQ(coveringPlane(volume.grid(), PatientPlane::axial, {}).size, glm::ivec2(8, 32));
}

TEST(Reformat, ofAVeryLargeSliceIsItsDefinition) {
  Grid grid = plainGrid({4096, 4096, 1}, {0.1, 0.1, 2.0});
  std::vector<std::uint8_t> stored(4096 * 4096);
  for (std::size_t i = 0; i < stored.size(); ++i)
    stored[i] = static_cast<std::uint8_t>(i * 7 % 251);
  const Volume volume(grid, std::move(stored), {}, std::nullopt, {});
  for (const PatientPlane plane : patientPlanes)
    expectDefined(volume, coveringPlane(grid, plane, middleVoxelMm(grid)), {}, 61);
}

TEST(Reformat, beyondTheVolumeIsEmpty) {
  const Volume volume = noiseOf(plainGrid({4, 4, 4}));
  for (const PatientPlane plane : patientPlanes)
    for (const double thickness : {0.0, 5.0}) {
      const PlaneGrid far = coveringPlane(volume.grid(), plane, glm::dvec3(1e4));
      for (const double value :
           reformatted(volume, far, {PlaneInterpolation::linear, {Slab::Mode::mean, thickness}}).values)
        EXPECT_TRUE(std::isnan(value));
    }
}

TEST(Reformat, ofAThickSlabThatLeavesTheVolumeTakesWhatIsInside) {
  // One slice, 1 mm thick, all 7: a slab of 9 mm around it has one sample inside.
  const Volume volume = test::volumeOf(plainGrid({3, 3, 1}), [](const glm::ivec3&) { return 7.0; });
  const PlaneGrid axial = coveringPlane(volume.grid(), PatientPlane::axial, {});
  for (const Slab::Mode mode : modes)
    for (const double value : reformatted(volume, axial, {PlaneInterpolation::linear, {mode, 9.0}}).values)
      EXPECT_EQ(value, 7.0);
}

TEST(Reformat, ofAConstantVolumeIsConstantToTheLastBit) {
  const Volume volume = test::volumeOf(turnedGrid({9, 9, 9}, {1.0, 1.0, 1.0}, 45.0, {0.0, 0.0, 1.0}),
                                       [](const glm::ivec3&) { return 0.1f; });
  for (const PatientPlane plane : patientPlanes)
    for (const double value :
         reformatted(volume, coveringPlane(volume.grid(), plane, boxCentreMm(volume.grid())), {}).values)
      if (!std::isnan(value)) {
        EXPECT_EQ(value, volume.range().lowest);
      }
}

TEST(Reformat, ofSlicesOfAGridOfThePatientAreTheVoxels) {
  const Volume volume = noiseOf(plainGrid({5, 4, 3}));
  const PlaneImage axial =
      reformatted(volume, coveringPlane(volume.grid(), PatientPlane::axial, {0.0, 0.0, 2.0}), {});
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i)
      EXPECT_EQ(axial.at(i, j), volume.value({i, j, 2}));
}

TEST(Reformat, isTheSameForAnyNumberOfThreads) {
  const Volume volume = noiseOf(turnedGrid({64, 50, 40}, {0.8, 1.1, 2.3}, 30.0, {0.3, 1.0, -0.7}));
  const PlaneGrid plane = coveringPlane(volume.grid(), PatientPlane::coronal, boxCentreMm(volume.grid()));
  const PlaneSampling slab{PlaneInterpolation::linear, {Slab::Mode::mean, 40.0}};
  const PlaneImage one = reformatted(volume, plane, slab, {1, {}, {}});
  const PlaneImage many = reformatted(volume, plane, slab, {5, {}, {}});
  for (std::size_t i = 0; i < one.values.size(); ++i)
    if (!std::isnan(one.values[i]) || !std::isnan(many.values[i])) {
      ASSERT_EQ(one.values[i], many.values[i]);
    }
}

TEST(Reformat, endsWhereItIsCancelled) {
  const Volume volume = noiseOf(plainGrid({64, 64, 4}));
  EXPECT_THROW(reformatted(volume, coveringPlane(volume.grid(), PatientPlane::axial, {}), {},
                           {0, [] { return true; }, {}}),
               Cancelled);
}

// The weights of a region: trilinear as the picture takes them (weightAt), nearest as label maps have them.
TEST(PlaneWeights, areThoseOfTheRegion) {
  const Grid grid = turnedGrid({9, 8, 7}, {1.0, 1.2, 1.7}, 25.0, {1.0, -1.0, 2.0});
  std::mt19937 random(3);
  std::vector<std::uint8_t> places(9 * 8 * 7);
  for (std::uint8_t& place : places)
    place = static_cast<std::uint8_t>(random() % 2);
  Region region = bodyRegion(grid.dims, places);
  region.weights = {0.25, 1.0};
  const PlaneGrid plane = coveringPlane(grid, PatientPlane::coronal, boxCentreMm(grid));
  const PlaneImage weights = weightsOn(region, grid, plane, PlaneInterpolation::linear);
  for (int y = 0; y < plane.size.y; ++y)
    for (int x = 0; x < plane.size.x; ++x)
      if (!std::isnan(weights.at(x, y))) {
        EXPECT_NEAR(weights.at(x, y), weightAt(region, worldToIndex(grid, pixelToWorld(plane, {x, y}))),
                    1e-12);
      }
  for (const double weight : weightsOn(region, grid, plane, PlaneInterpolation::nearest).values)
    EXPECT_TRUE(std::isnan(weight) || weight == 0.25 || weight == 1.0);
  for (const double weight : weightsOn({}, grid, plane, PlaneInterpolation::linear).values)
    EXPECT_TRUE(std::isnan(weight) || weight == 1.0);
}

// "A slice follows the pointer within 16 ms on 512×512×300": one of each plane, as large as the volume. Thick
// slabs of oblique volumes read thirty voxels a pixel and take longer.
TEST(PlaneTimes, keepWithThePointer) {
  const bool isBench = std::getenv("LIMN_BENCH") != nullptr;
  const Volume volume =
      noiseOf(turnedGrid({512, 512, isBench ? 300 : 10}, {0.7, 0.7, 1.0}, 0.0, {0.0, 0.0, 1.0}));
  const Volume oblique =
      volume.placed(turnedGrid(volume.grid().dims, volume.grid().spacingMm, 20.0, {1.0, 1.0, 1.0}), {});
  for (const Volume* each : {&volume, &oblique})
    for (const PatientPlane plane : patientPlanes)
      for (const double thickness : {0.0, 10.0}) {
        double shortest = 1e9;
        for (int turn = 0; turn < 9; ++turn) {
          const glm::dvec3 place = boxCentreMm(each->grid()) + glm::dvec3(turn);
          const auto start = std::chrono::steady_clock::now();
          const PlaneImage image =
              reformatted(*each, coveringPlane(each->grid(), plane, place),
                          {PlaneInterpolation::linear, {Slab::Mode::maximum, thickness}});
          const double ms =
              std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
          ASSERT_FALSE(image.values.empty());
          shortest = std::min(shortest, ms);
        }
        const std::string what = std::string(nameOf(plane)) + (each == &oblique ? ", oblique" : "") +
                                 (thickness > 0.0 ? ", slab of 10 mm" : "");
        test::judgeMs(what, shortest, thickness > 0.0 && each == &oblique ? 80.0 : 16.0);
      }
}

} // namespace
} // namespace limn
