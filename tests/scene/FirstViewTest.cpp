// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/FirstView.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

void expectAlong(const glm::dvec3& seen, const glm::dvec3& expected) {
  EXPECT_NEAR(glm::dot(seen, expected), 1.0, 1e-12) << seen.x << ' ' << seen.y << ' ' << seen.z;
}

Grid gridOf(const glm::ivec3& dims) {
  Grid grid;
  grid.dims = dims;
  return grid;
}

TEST(FirstView, isTheDefaultCameraWhereNoAxisOrMoreThanOneHasASingleSample) {
  for (const glm::ivec3 dims : {glm::ivec3(10, 20, 30), glm::ivec3(10, 20, 2), glm::ivec3(1, 1, 30)}) {
    const Grid grid = gridOf(dims);
    EXPECT_EQ(firstView(defaultCamera(grid), grid, true), defaultCamera(grid));
  }
}

// As radiologists look: an axial slice from the feet with the front up, so that the patient's left (+x in
// LPS) is on the right; a coronal one from the front; a sagittal one from the left, the face to the left.
TEST(FirstView, showsASingleSliceFaceOnAndUpright) {
  const auto basisOn = [](const glm::ivec3& dims) {
    const Grid grid = gridOf(dims);
    return basisOf(firstView(defaultCamera(grid), grid, true));
  };
  const CameraBasis axial = basisOn({128, 128, 1});
  expectAlong(axial.forward, {0, 0, 1});
  expectAlong(axial.up, {0, -1, 0});
  expectAlong(axial.right, {1, 0, 0});
  const CameraBasis coronal = basisOn({128, 1, 128});
  expectAlong(coronal.forward, {0, 1, 0});
  expectAlong(coronal.up, {0, 0, 1});
  const CameraBasis sagittal = basisOn({1, 128, 128});
  expectAlong(sagittal.forward, {-1, 0, 0});
  expectAlong(sagittal.right, {0, 1, 0});
}

// 64 mm wide and high: 7 slices of 3 mm are 21 mm thick, less than a third of that; 8 are more.
TEST(FirstView, showsAThinStackFaceOnWhereNobodyKnowsItsFront) {
  Grid grid = gridOf({64, 64, 7});
  grid.spacingMm.z = 3.0;
  const CameraBasis basis = basisOf(firstView(defaultCamera(grid), grid, false));
  expectAlong(basis.forward, {0, 0, 1});
  expectAlong(basis.up, {0, -1, 0});
  EXPECT_EQ(firstView(defaultCamera(grid), grid, true), defaultCamera(grid)) << "the file tells the front";
  grid.dims.z = 8;
  EXPECT_EQ(firstView(defaultCamera(grid), grid, false), defaultCamera(grid));
  const Grid rod = gridOf({5, 5, 64});
  EXPECT_EQ(firstView(defaultCamera(rod), rod, false), defaultCamera(rod)) << "thin along two axes";
}

TEST(FirstView, standsUprightOnATiltedSliceHoweverItsAxesAreStored) {
  const double c = std::cos(0.3), s = std::sin(0.3);
  Grid grid = gridOf({128, 1, 64});
  // Tilted about the patient's left; its normal is the second axis, its rows run up.
  grid.direction = {glm::dvec3(0, -c, -s), glm::dvec3(0, s, -c), glm::dvec3(1, 0, 0)};
  const CameraBasis basis = basisOf(firstView(defaultCamera(grid), grid, true));
  expectAlong(basis.forward, {0, -s, c});
  expectAlong(basis.up, {0, -c, -s});
}

} // namespace
} // namespace limn
