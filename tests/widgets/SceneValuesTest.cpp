// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/CropFaces.h"
#include "widgets/properties/FogSection.h"

#include <gtest/gtest.h>

#include <cmath>

// What the sections of the scene compute without a widget.

namespace limn {
namespace {

Grid tenGrid() {
  Grid grid;
  grid.dims = {10, 10, 10};
  return grid;
}

QString axes(const Grid& grid, bool known = true) {
  QString text;
  for (const AxisName& name : axisNames(grid, known))
    text += name.axis + QLatin1Char(' ');
  return text.trimmed();
}

TEST(AxisNames, followThePatientInTheOrderOfTheIndices) {
  Grid grid = tenGrid();
  // LPS: +x is the patient's left, +y the back, +z the head.
  EXPECT_EQ(axes(grid), QStringLiteral("Right–Left Front–Back Feet–Head"));
  grid.direction = glm::dmat3(glm::dvec3(-1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
  EXPECT_EQ(axes(grid), QStringLiteral("Left–Right Back–Front Head–Feet"));
  // A sagittal series: columns run to the back, rows to the feet, slices to the left.
  grid.direction = glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0));
  EXPECT_EQ(axes(grid), QStringLiteral("Front–Back Head–Feet Right–Left"));
  EXPECT_EQ(axisNames(grid, true)[1].lowEnd, QStringLiteral("Head"));
}

TEST(AxisNames, ofAnObliqueGridUseEveryDirectionOnce) {
  Grid grid = tenGrid();
  // Turned by 50° about the patient's long axis: both in-plane axes lie nearer to the other's direction.
  const double c = std::cos(50.0 * std::acos(-1.0) / 180.0);
  const double s = std::sqrt(1.0 - c * c);
  grid.direction = glm::dmat3(glm::dvec3(c, s, 0), glm::dvec3(-s, c, 0), glm::dvec3(0, 0, 1));
  EXPECT_EQ(axes(grid), QStringLiteral("Front–Back Left–Right Feet–Head"));
}

TEST(AxisNames, withoutAnOrientationSayWhatIsStacked) {
  EXPECT_EQ(axes(tenGrid(), false), QStringLiteral("Columns Rows Slices"));
}

TEST(CropFaces, aFaceStaysInsideTheVolumeAndOneVoxelFromTheOther) {
  const Grid grid = tenGrid();
  CropBox crop;
  crop.lower.y = 0.4;
  EXPECT_EQ(withFaceAt(crop, grid, {1, true}, 0.7).upper, glm::dvec3(1.0, 0.7, 1.0));
  EXPECT_EQ(withFaceAt(crop, grid, {1, true}, 1.7).upper.y, 1.0);
  EXPECT_DOUBLE_EQ(withFaceAt(crop, grid, {1, true}, -3.0).upper.y, 0.5); // one of ten voxels
  EXPECT_DOUBLE_EQ(withFaceAt(crop, grid, {1, false}, INFINITY).lower.y, 0.9);
  EXPECT_EQ(withFaceAt(crop, grid, {1, false}, -INFINITY).lower.y, 0.0);
}

TEST(CropFaces, anAxisOfOneVoxelCannotBeCut) {
  Grid grid = tenGrid();
  grid.dims.z = 1;
  EXPECT_EQ(withFaceAt({}, grid, {2, true}, 0.3), CropBox{});
  EXPECT_EQ(withFaceAt({}, grid, {2, false}, 0.3), CropBox{});
}

TEST(CropFaces, countVoxelsByTheirCentres) {
  const Grid grid = tenGrid();
  EXPECT_EQ(voxelsInside({}, grid, 0), (VoxelSpan{1, 10}));
  CropBox crop;
  // Centres lie at 0.05, 0.15, …: from 0.3 the fourth is inside, up to 0.74 the seventh (0.65).
  crop.lower.x = 0.3;
  crop.upper.x = 0.74;
  EXPECT_EQ(voxelsInside(crop, grid, 0), (VoxelSpan{4, 7}));
  crop.upper.x = 0.76; // 0.75 is inside
  EXPECT_EQ(voxelsInside(crop, grid, 0), (VoxelSpan{4, 8}));
  EXPECT_NEAR(shareLeft(crop), 0.46, 1e-12);
}

Scene frontScene() {
  Scene scene;
  Grid grid = tenGrid();
  scene.volume =
      std::make_shared<Volume>(grid, std::vector<float>(1000, 1.0f), Rescale{}, std::nullopt, VolumeInfo{});
  // 100 mm before the centre of a cube from -0.5 to 9.5: it begins at 95 mm and ends at 105.
  scene.camera.position = {4.5, -95.5, 4.5};
  scene.camera.target = {4.5, 4.5, 4.5};
  return scene;
}

TEST(FogFit, beginsWhereTheVolumeDoesAndLeavesAFifthAtItsFarEnd) {
  const Scene scene = frontScene();
  const DepthRange depth = depthRange(scene.camera, scene.volume->grid());
  EXPECT_NEAR(depth.nearMm, 95.0, 1e-9);
  EXPECT_NEAR(depth.farMm, 105.0, 1e-9);
  const Fog linear = withFogMode(scene, Fog::Mode::linear);
  EXPECT_EQ(linear.startMm, 95.0);
  EXPECT_EQ(linear.color, scene.image.background);
  // (end - 105)/(end - 95) = 0.2 at end = 107.5, rounded to whole mm.
  EXPECT_EQ(linear.endMm, 108.0);
  // Two digits of ρ, so to one part in twenty of the exponent.
  const Fog exponential = withFogMode(scene, Fog::Mode::exp);
  EXPECT_NEAR(exponential.densityPerMm * 10.0, -std::log(0.2), 0.05 * 1.61);
  const Fog squared = withFogMode(scene, Fog::Mode::exp2);
  EXPECT_NEAR(std::pow(squared.densityPerMm * 10.0, 2.0), -std::log(0.2), 0.1 * 1.61);
}

TEST(FogFit, keepsNumbersThatWereSet) {
  Scene scene = frontScene();
  scene.fog = {Fog::Mode::exp, {1.0, 0.0, 0.0}, 0.25, 12.0, 900.0};
  Fog expected = scene.fog;
  for (const auto mode : {Fog::Mode::linear, Fog::Mode::exp2, Fog::Mode::none}) {
    expected.mode = mode;
    EXPECT_EQ(withFogMode(scene, mode), expected);
  }
}

} // namespace
} // namespace limn
