// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlaneVolumes.h"

#include "planes/PlaneGrid.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

using test::coveringPlane;

// The area of a flat polygon: half the length of the sum of the cross products around it.
double areaOf(const std::vector<glm::dvec3>& corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += glm::cross(corners[i], corners[(i + 1) % corners.size()]);
  return glm::length(sum) / 2.0;
}

TEST(CropOutline, isTheRectangleOfAVolumeOnTheAxesOfThePatient) {
  const Grid grid = test::plainGrid({10, 20, 30}, {1.0, 2.0, 0.5});
  const CropBox crop{{0.2, 0.5, 0.0}, {0.7, 1.0, 1.0}};
  const PlaneGrid axial = coveringPlane(grid, PatientPlane::axial, {0.0, 0.0, 3.0});
  const std::vector<glm::dvec3> corners = cropOutline(grid, crop, axial);
  ASSERT_EQ(corners.size(), 4u);
  // The box fills -0.5 to 9.5 and -1 to 39 mm: x from 1.5 to 6.5, y from 19 to 39.
  EXPECT_NEAR(areaOf(corners), 5.0 * 20.0, 1e-9);
  for (const glm::dvec3& corner : corners) {
    EXPECT_TRUE(std::abs(corner.x - 1.5) < 1e-12 || std::abs(corner.x - 6.5) < 1e-12) << corner.x;
    EXPECT_TRUE(std::abs(corner.y - 19.0) < 1e-12 || std::abs(corner.y - 39.0) < 1e-12) << corner.y;
    EXPECT_NEAR(corner.z, 3.0, 1e-12);
  }
}

TEST(CropOutline, isNotThereWithoutACropOrBesideTheBox) {
  const Grid grid = test::plainGrid({10, 10, 10});
  const PlaneGrid low = coveringPlane(grid, PatientPlane::axial, {0.0, 0.0, 1.0});
  EXPECT_TRUE(cropOutline(grid, {}, low).empty());
  EXPECT_TRUE(cropOutline(grid, {{0.0, 0.0, 0.5}, {1.0, 1.0, 1.0}}, low).empty());
}

TEST(CropOutline, ofAnObliqueVolumeIsTheCutThroughItsBox) {
  // A cube of 8 mm turned by 45° about the sagittal axis: through its middle an axial plane cuts it along its
  // diagonal, 8 by 8·√2; half of it along that axis is 4 by 8·√2.
  const Grid grid = test::turnedGrid({8, 8, 8}, glm::dvec3(1.0), 45.0, {1.0, 0.0, 0.0});
  const PlaneGrid axial = coveringPlane(grid, PatientPlane::axial, boxCentreMm(grid));
  const std::vector<glm::dvec3> corners = cropOutline(grid, {{0.0, 0.0, 0.0}, {0.5, 1.0, 1.0}}, axial);
  EXPECT_NEAR(areaOf(corners), 4.0 * 8.0 * std::sqrt(2.0), 1e-6);
  // About the space diagonal a plane may cut six edges; every corner lies in the plane and on the box.
  const Grid tilted = test::turnedGrid({8, 8, 8}, glm::dvec3(1.0), 50.0, {1.0, 1.0, 0.0});
  const CropBox crop{{0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}};
  const PlaneGrid plane = coveringPlane(tilted, PatientPlane::axial, boxCentreMm(tilted));
  const std::vector<glm::dvec3> cut = cropOutline(tilted, crop, plane);
  EXPECT_GE(cut.size(), 4u);
  for (const glm::dvec3& corner : cut) {
    EXPECT_NEAR(glm::dot(corner - plane.originMm, plane.axes.forward), 0.0, 1e-9);
    const glm::dvec3 inBox = (worldToIndex(tilted, corner) + 0.5) / 8.0;
    EXPECT_NEAR(glm::clamp(inBox, crop.lower, crop.upper).x, inBox.x, 1e-9);
    EXPECT_NEAR(glm::clamp(inBox, crop.lower, crop.upper).y, inBox.y, 1e-9);
    EXPECT_NEAR(glm::clamp(inBox, crop.lower, crop.upper).z, inBox.z, 1e-9);
  }
}

} // namespace
} // namespace limn
