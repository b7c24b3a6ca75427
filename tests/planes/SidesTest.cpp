// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlaneVolumes.h"

#include "scene/volume/Orientation.h"

#include <gtest/gtest.h>

// Left is left in every plane, whatever way the file's axes run.
namespace limn {
namespace {

using test::coveringPlane;

// A voxel that is far to the patient's left, a little to the front, and high: its place tells all six sides.
// The patient's box is 40 × 30 × 20 mm about the origin, in voxels of 1 mm.
constexpr glm::dvec3 markMm{15.5, -4.5, 7.5};

Volume markedVolume(const std::string& letters) {
  Grid grid;
  const std::string patient = "LPS";
  for (int axis = 0; axis < 3; ++axis) {
    const std::string sides = letters.substr(static_cast<std::size_t>(axis), 1);
    grid.dims[axis] = sides == "L" || sides == "R" ? 40 : sides == "P" || sides == "A" ? 30 : 20;
  }
  grid = withAxisLetters(grid, letters);
  grid.originMm -= boxCentreMm(grid);
  const glm::ivec3 mark(glm::round(worldToIndex(grid, markMm)));
  return test::volumeOf(grid, [mark](const glm::ivec3& voxel) { return voxel == mark ? 1.0 : 0.0; });
}

// Where the plane through the mark shows it, as fractions of its width and height.
glm::dvec2 markIn(const Volume& volume, PatientPlane plane) {
  const PlaneGrid covering = coveringPlane(volume.grid(), plane, markMm);
  const PlaneImage image = reformatted(volume, covering, {});
  glm::dvec2 found(-1.0);
  for (int y = 0; y < image.size.y; ++y)
    for (int x = 0; x < image.size.x; ++x)
      if (image.at(x, y) > 0.99)
        found = (glm::dvec2(x, y) + 0.5) / glm::dvec2(image.size);
  return found;
}

TEST(Sides, areWhereRadiologistsLookForThemInAllOrientations) {
  std::array<int, 3> order{0, 1, 2};
  int orientations = 0;
  do {
    for (int flips = 0; flips < 8; ++flips) {
      std::string letters;
      for (int axis = 0; axis < 3; ++axis)
        letters += std::array{
            "RL", "AP",
            "IS"}[static_cast<std::size_t>(order[static_cast<std::size_t>(axis)])][flips >> axis & 1];
      SCOPED_TRACE(letters);
      const Volume volume = markedVolume(letters);
      // The patient's left is at the viewer's right: (15.5 + 20)/40. The front is above: (-4.5 + 15)/30.
      EXPECT_EQ(markIn(volume, PatientPlane::axial), glm::dvec2(35.5 / 40.0, 10.5 / 30.0));
      // The head is above: (10 - 7.5)/20.
      EXPECT_EQ(markIn(volume, PatientPlane::coronal), glm::dvec2(35.5 / 40.0, 2.5 / 20.0));
      // The front is at the left.
      EXPECT_EQ(markIn(volume, PatientPlane::sagittal), glm::dvec2(10.5 / 30.0, 2.5 / 20.0));
      ++orientations;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(orientations, 48);
}

TEST(Sides, ofTheNextSliceAreHeadFrontAndLeft) {
  EXPECT_EQ(axesOf(PatientPlane::axial).forward, glm::dvec3(0, 0, 1));
  EXPECT_EQ(axesOf(PatientPlane::coronal).forward, glm::dvec3(0, -1, 0));
  EXPECT_EQ(axesOf(PatientPlane::sagittal).forward, glm::dvec3(1, 0, 0));
}

} // namespace
} // namespace limn
