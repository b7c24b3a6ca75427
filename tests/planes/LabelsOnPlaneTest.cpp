// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/LabelsOnPlane.h"

#include <gtest/gtest.h>

// Labels on a slice, against the voxel nearest to each pixel.

namespace limn {
namespace {

constexpr std::uint32_t plainGrey = 0xff808080, labelRed = 0xffff0000;

// Two labels: the second fills [2, 6) × [1, 4) of a slice.
LabelMap twoLabels(const glm::ivec3& dims) {
  StoredVoxels<std::uint8_t> places(
      std::vector<std::uint8_t>(static_cast<std::size_t>(dims.x) * dims.y * dims.z));
  std::vector<std::uint8_t> filled(places.begin(), places.end());
  for (int k = 0; k < dims.z; ++k)
    for (int j = 1; j < 4; ++j)
      for (int i = 2; i < 6; ++i)
        filled[voxelOffset(dims, i, j, k)] = 1;
  return LabelMap(dims, StoredVoxels<std::uint8_t>(std::move(filled)),
                  {{0, "background", glm::dvec3(1.0)}, {7, "liver", glm::dvec3(1.0)}});
}

TEST(LabelsOnPlane, areThoseOfTheNearestVoxels) {
  Grid grid;
  grid.dims = {8, 6, 3};
  grid.spacingMm = {2.0, 3.0, 4.0};
  grid.originMm = {-5.0, 4.0, 1.0};
  const double a = 0.3;
  grid.direction = {glm::dvec3(std::cos(a), std::sin(a), 0), glm::dvec3(-std::sin(a), std::cos(a), 0),
                    glm::dvec3(0, 0, 1)};
  const LabelMap map = twoLabels(grid.dims);
  PlaneGrid plane;
  plane.size = {40, 40};
  plane.spacingMm = 0.7;
  plane.originMm = {-15.0, -2.0, 1.0};
  const PlanePlaces labels = placesOn(map, grid, plane);
  int inside = 0, outside = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const glm::dvec3 index = worldToIndex(grid, pixelToWorld(plane, {x, y}));
      const glm::ivec3 voxel(glm::floor(index + 0.5));
      const bool isIn =
          glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) && glm::all(glm::lessThan(voxel, grid.dims));
      (isIn ? inside : outside) += 1;
      EXPECT_EQ(labels.places[static_cast<std::size_t>(40 * y + x)],
                isIn ? map.placeAt(voxelOffset(grid.dims, voxel.x, voxel.y, voxel.z)) : PlanePlaces::nowhere);
    }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100);
}

TEST(LabelsOnPlane, arePaintedWithAnEdgeAndAVeilWithin) {
  Grid grid;
  grid.dims = {8, 6, 1};
  PlaneGrid plane; // a pixel a voxel
  plane.size = {8, 6};
  const PlanePlaces labels = placesOn(twoLabels(grid.dims), grid, plane);
  std::vector<std::uint32_t> pixels(48, plainGrey);
  pixels[1 * 8 + 2] = 0; // outside the volume, as planePixels says it
  paintLabels(pixels, labels, {0, labelRed}, 0.25, 1);
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x) {
      const bool isLabel = x >= 2 && x < 6 && y >= 1 && y < 4;
      const bool isWithin = x >= 3 && x < 5 && y == 2;
      // A quarter of the way from grey to red: 128 + 127/4 = 160 (rounded), 128 · 3/4 = 96.
      const std::uint32_t expected = x == 2 && y == 1 ? 0
                                     : isWithin       ? 0xffa06060
                                     : isLabel        ? labelRed
                                                      : plainGrey;
      EXPECT_EQ(pixels[static_cast<std::size_t>(8 * y + x)], expected) << x << ", " << y;
    }
}

} // namespace
} // namespace limn
