// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlaneVolumes.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

using test::coveringPlane;
using test::plainGrid;
using test::turnedGrid;

void expectCovered(const Grid& grid, const PlaneGrid& plane) {
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec2 pixel = worldToPixel(plane, indexToWorld(grid, side * glm::dvec3(grid.dims) - 0.5));
    for (int axis = 0; axis < 2; ++axis) {
      // Pixels own half a pixel around their centre; rounding up adds less than one to the last.
      EXPECT_GE(pixel[axis], -0.5 - 1e-6);
      EXPECT_LE(pixel[axis], plane.size[axis] - 0.5 + 1e-5);
    }
  }
}

TEST(PlaneGrid, coversTheVolumeHoweverItLies) {
  for (const double degrees : {0.0, 7.7, 45.0, 120.0})
    for (const PatientPlane plane : patientPlanes) {
      const Grid grid = turnedGrid({30, 20, 11}, {0.7, 1.3, 2.5}, degrees, {1.0, 2.0, -0.5});
      const PlaneGrid covering = coveringPlane(grid, plane, boxCentreMm(grid));
      expectCovered(grid, covering);
      EXPECT_EQ(covering.spacingMm, 0.7) << "the smallest";
      EXPECT_NEAR(glm::dot(covering.originMm - boxCentreMm(grid), covering.axes.forward), 0.0, 1e-9)
          << "through the place that was asked for";
    }
}

TEST(PlaneGrid, hasThePixelsOfVoxelsWhereAxesAgree) {
  const Grid grid = plainGrid({5, 4, 3});
  const PlaneGrid axial = coveringPlane(grid, PatientPlane::axial, {0.0, 0.0, 1.0});
  EXPECT_EQ(axial.size, glm::ivec2(5, 4));
  EXPECT_EQ(axial.originMm, glm::dvec3(0.0, 0.0, 1.0));
  const PlaneGrid coronal = coveringPlane(grid, PatientPlane::coronal, {0.0, 2.0, 0.0});
  EXPECT_EQ(coronal.size, glm::ivec2(5, 3));
  EXPECT_EQ(coronal.originMm, glm::dvec3(0.0, 2.0, 2.0)) << "the head is above";
  EXPECT_EQ(coveringPlane(grid, PatientPlane::sagittal, {2.0, 0.0, 0.0}).size, glm::ivec2(4, 3));
}

TEST(PlaneGrid, canBeCoarserInTheSamePlace) {
  const PlaneGrid fine = coveringPlane(plainGrid({7, 4, 3}), PatientPlane::axial, {0.0, 0.0, 1.0});
  EXPECT_EQ(coarser(fine, 1), fine);
  const PlaneGrid coarse = coarser(fine, 3);
  EXPECT_EQ(coarse.size, glm::ivec2(3, 2));
  EXPECT_EQ(pixelToWorld(coarse, {1.0, 0.0}), pixelToWorld(fine, {4.0, 1.0})) << "in the middle of its nine";
}

TEST(PlaneGrid, leadsThereAndBack) {
  const Grid grid = turnedGrid({9, 9, 9}, {1.0, 1.0, 2.0}, 33.0, {1.0, 1.0, 1.0});
  for (const PatientPlane plane : patientPlanes) {
    const PlaneGrid covering = coveringPlane(grid, plane, boxCentreMm(grid));
    const glm::dvec2 pixel = worldToPixel(covering, pixelToWorld(covering, {3.25, 7.5}));
    EXPECT_NEAR(pixel.x, 3.25, 1e-9);
    EXPECT_NEAR(pixel.y, 7.5, 1e-9);
  }
}

TEST(PlaneGrid, stepsByTheSpacingAcrossThePlane) {
  // Turned by 90° about x: rows run down, slices to the front.
  const Grid turned = turnedGrid({4, 4, 4}, {0.5, 0.75, 3.0}, 90.0, {1.0, 0.0, 0.0});
  EXPECT_EQ(sliceStepMm(turned, PatientPlane::sagittal), 0.5);
  EXPECT_EQ(sliceStepMm(turned, PatientPlane::axial), 0.75);
  EXPECT_EQ(sliceStepMm(turned, PatientPlane::coronal), 3.0);
  // 8° are no other axis.
  const Grid tilted = turnedGrid({4, 4, 4}, {0.5, 0.75, 3.0}, 8.0, {1.0, 0.0, 0.0});
  EXPECT_EQ(sliceStepMm(tilted, PatientPlane::axial), 3.0);
}

TEST(PlaneGrid, tellsWhatLiesInsideTheBox) {
  const Grid grid = plainGrid({4, 4, 1}, {1.0, 1.0, 5.0});
  EXPECT_TRUE(isInside(grid, {-0.5, 0.0, 2.4}));
  EXPECT_FALSE(isInside(grid, {3.5, 0.0, 0.0}));
  EXPECT_FALSE(isInside(grid, {0.0, 0.0, 2.5}));
  EXPECT_EQ(middleVoxelMm(grid), glm::dvec3(1.0, 1.0, 0.0));
  const ReachMm reach = reachAlong(grid, {0.0, 0.0, -1.0});
  EXPECT_DOUBLE_EQ(reach.first, -2.5);
  EXPECT_DOUBLE_EQ(reach.last, 2.5);
}

} // namespace
} // namespace limn
