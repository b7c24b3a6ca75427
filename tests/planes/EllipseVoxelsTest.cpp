// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/EllipseVoxels.h"
#include "PlaneVolumes.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

// What an ellipse says of the voxels in it, against closed forms.

namespace limn {
namespace {

constexpr double pi = std::numbers::pi;

Measurement ellipseAt(PatientPlane plane, const glm::dvec3& centreMm, double a, double b) {
  const PlaneAxes axes = axesOf(plane);
  const glm::dvec3 half = a * axes.right + b * axes.down;
  return {Measurement::Kind::ellipse, plane, {centreMm - half, centreMm + half}};
}

// A volume whose scalar rises by `slope` per mm along a direction of the world.
Volume rampAlong(const Grid& grid, const glm::dvec3& slope) {
  return test::volumeOf(grid,
                        [&](const glm::ivec3& index) { return glm::dot(slope, indexToWorld(grid, index)); });
}

// Over an ellipse that is filled evenly the square of x / a has the mean 1/4: a ramp of slope s along the
// semi-axis a deviates by a s / 2, and its mean is the value in the middle. Voxels are squares of h mm: what
// they fill lies between ellipses whose semi-axes are half a diagonal of a voxel shorter and longer, so that
// the deviation errs by at most s / 2 · 0.71 h, and by what a voxel's own width adds, far less.
TEST(EllipseVoxels, aRampAlongASemiAxisDeviatesByHalfItsRise) {
  const double h = 0.5, slope = 8.0;
  const Grid grid = test::plainGrid({160, 120, 5}, {h, h, 3.0});
  const glm::dvec3 centre = indexToWorld(grid, {80, 60, 2});
  for (const auto& [a, b] : {std::pair(30.0, 20.0), std::pair(12.0, 25.0), std::pair(9.3, 9.3)}) {
    const Measurement ellipse = ellipseAt(PatientPlane::axial, centre, a, b);
    const EllipseFigures alongX = ellipseFigures(rampAlong(grid, {slope, 0, 0}), ellipse);
    EXPECT_NEAR(alongX.mean, slope * centre.x, 1e-4) << "voxels lie evenly about the middle; floats";
    EXPECT_NEAR(alongX.deviation, a * slope / 2.0, slope * 0.36 * h) << a;
    const EllipseFigures alongY = ellipseFigures(rampAlong(grid, {0, slope, 0}), ellipse);
    EXPECT_NEAR(alongY.deviation, b * slope / 2.0, slope * 0.36 * h) << b;
    EXPECT_DOUBLE_EQ(alongX.areaMm2, pi * a * b);
    // A border of half a diagonal to each side, of at most the circumference of the circle around.
    EXPECT_NEAR(static_cast<double>(alongX.voxels) * h * h, pi * a * b, 2.0 * pi * std::max(a, b) * 0.71 * h);
    EXPECT_EQ(alongX.lowest + alongX.highest, 2.0 * slope * centre.x);
    EXPECT_LE(alongX.highest, slope * (centre.x + a) + 1e-3);
  }
}

TEST(EllipseVoxels, eachPlaneHasItsOwnAxes) {
  const Grid grid = test::plainGrid({64, 64, 64}, {1.0, 1.0, 1.0});
  const glm::dvec3 centre(32.0);
  const auto deviation = [&](PatientPlane plane, const glm::dvec3& slope) {
    return ellipseFigures(rampAlong(grid, slope), ellipseAt(plane, centre, 24.0, 10.0)).deviation;
  };
  const double bound = 0.36; // as above, h = slope = 1
  EXPECT_NEAR(deviation(PatientPlane::axial, {1, 0, 0}), 12.0, bound);
  EXPECT_NEAR(deviation(PatientPlane::axial, {0, 1, 0}), 5.0, bound);
  EXPECT_EQ(deviation(PatientPlane::axial, {0, 0, 1}), 0.0) << "one slice alone";
  EXPECT_NEAR(deviation(PatientPlane::coronal, {1, 0, 0}), 12.0, bound);
  EXPECT_NEAR(deviation(PatientPlane::coronal, {0, 0, 1}), 5.0, bound);
  EXPECT_NEAR(deviation(PatientPlane::sagittal, {0, 1, 0}), 12.0, bound);
  EXPECT_NEAR(deviation(PatientPlane::sagittal, {0, 0, 1}), 5.0, bound);
}

// The plane is the patient's, whichever way the voxels lie: area and mean stay, voxels are those within half
// a slice of it. Those lie evenly about a voxel's centre; a slab of one voxel's width that is cut askew holds
// as many voxels as volume, but for its border.
TEST(EllipseVoxels, obliqueGridsAreMeasuredInThePatientsPlane) {
  for (const auto& [degrees, axis] :
       {std::pair(30.0, glm::dvec3(0, 0, 1)), std::pair(25.0, glm::dvec3(1, 2, 3))}) {
    const Grid grid = test::turnedGrid({90, 90, 60}, {0.8, 0.8, 0.8}, degrees, axis);
    const glm::dvec3 centre = indexToWorld(grid, {45, 45, 30});
    const double a = 20.0, b = 12.0, slope = 4.0;
    const EllipseFigures figures =
        ellipseFigures(rampAlong(grid, {slope, 0, 0}), ellipseAt(PatientPlane::axial, centre, a, b));
    EXPECT_DOUBLE_EQ(figures.areaMm2, pi * a * b);
    EXPECT_NEAR(figures.mean, slope * centre.x, 1e-3) << "floats of values in the hundreds";
    EXPECT_NEAR(figures.deviation, a * slope / 2.0, slope * 0.8) << "a voxel at the border";
    EXPECT_NEAR(static_cast<double>(figures.voxels) * 0.8 * 0.8, pi * a * b, 2.0 * pi * a * 0.8);
  }
}

TEST(EllipseVoxels, aPlaneBetweenTwoSlicesHasTheVoxelsOfOne) {
  const Grid grid = test::plainGrid({40, 40, 6}, {1.0, 1.0, 2.5});
  const Volume volume = rampAlong(grid, {0, 0, 1});
  for (const double z : {5.0, 5.0 + 1.25, 7.5 - 1.25, 7.5 - 1.25 + 1e-13, 5.0 + 1.2499}) {
    const EllipseFigures figures =
        ellipseFigures(volume, ellipseAt(PatientPlane::axial, {20.0, 20.0, z}, 8.0, 8.0));
    EXPECT_EQ(figures.voxels, 197u) << "integer points of a circle of radius 8, z " << z;
    EXPECT_EQ(figures.deviation, 0.0) << "all of one slice, z " << z;
  }
}

TEST(EllipseVoxels, invalidVoxelsCountForNothing) {
  const Grid grid = test::plainGrid({21, 21, 1});
  const auto withHole = [&](double hole) {
    return test::volumeOf(grid, [=](const glm::ivec3& index) { return index.x == 10 ? hole : 7.0; });
  };
  const Measurement ellipse = ellipseAt(PatientPlane::axial, {10.0, 10.0, 0.0}, 5.0, 5.0);
  const EllipseFigures all = ellipseFigures(withHole(7.0), ellipse);
  const EllipseFigures holed = ellipseFigures(withHole(std::numeric_limits<double>::quiet_NaN()), ellipse);
  EXPECT_EQ(all.voxels, 81u) << "integer points of a circle of radius 5";
  EXPECT_EQ(holed.voxels, 81u - 11u) << "without its middle column";
  EXPECT_EQ(holed.mean, 7.0);
  EXPECT_EQ(holed.deviation, 0.0);
}

TEST(EllipseVoxels, withoutAVoxelThereIsAnAreaAlone) {
  const Volume volume = rampAlong(test::plainGrid({10, 10, 10}), {1, 1, 1});
  for (const Measurement& nowhere : {ellipseAt(PatientPlane::axial, {500.0, 0.0, 5.0}, 4.0, 3.0),
                                     ellipseAt(PatientPlane::axial, {5.0, 5.0, -1e6}, 4.0, 3.0),
                                     ellipseAt(PatientPlane::axial, {4.5, 4.5, 5.0}, 4.0, 0.0),
                                     ellipseAt(PatientPlane::axial, {4.5, 4.5, 5.0}, 0.1, 0.1)}) {
    const EllipseFigures figures = ellipseFigures(volume, nowhere);
    EXPECT_EQ(figures.voxels, 0u);
    EXPECT_EQ(figures.mean, 0.0);
    EXPECT_EQ(figures.deviation, 0.0);
  }
  EXPECT_DOUBLE_EQ(ellipseFigures(volume, ellipseAt(PatientPlane::axial, {500, 0, 5}, 4, 3)).areaMm2,
                   12 * pi);
}

TEST(EllipseVoxels, partlyOutsideOnlyWhatIsThereCounts) {
  const Volume volume = rampAlong(test::plainGrid({10, 10, 3}), {1, 0, 0});
  const EllipseFigures figures =
      ellipseFigures(volume, ellipseAt(PatientPlane::axial, {0.0, 5.0, 1.0}, 3.0, 1.0));
  EXPECT_EQ(figures.voxels, 6u) << "x 0 to 3 in the middle row, and the ends of the short axis";
  EXPECT_EQ(figures.lowest, 0.0);
  EXPECT_EQ(figures.highest, 3.0);
  EXPECT_DOUBLE_EQ(figures.mean, (0 + 1 + 2 + 3 + 0 + 0) / 6.0);
}

TEST(EllipseVoxels, whatLiesAsItDidIsNotReadAgain) {
  const Volume volume = rampAlong(test::plainGrid({20, 20, 3}), {1, 0, 0});
  Measurement ellipse = ellipseAt(PatientPlane::axial, {10.0, 10.0, 1.0}, 4.0, 4.0);
  const std::vector<Measured> first = measuredIn(&volume, {ellipse});
  EXPECT_DOUBLE_EQ(first.front().ellipse.mean, 10.0);
  const Volume other = rampAlong(test::plainGrid({20, 20, 3}), {2, 0, 0});
  ellipse.name = "renamed";
  EXPECT_EQ(measuredIn(&other, {ellipse}, first).front().ellipse, first.front().ellipse);
  EXPECT_DOUBLE_EQ(measuredIn(&other, {ellipse}).front().ellipse.mean, 20.0);
  EXPECT_DOUBLE_EQ(measuredIn(nullptr, {ellipse}).front().ellipse.areaMm2, 16.0 * pi);
}

} // namespace
} // namespace limn
