// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/LabelSurfaces.h"

#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

// Surfaces of labels: where the label's weight is a half, a mesh and a file for each.

namespace limn {
namespace {

// Cubes in a volume of 1.5 mm: one of 4³ voxels in the middle, one of 2³ at the corner of the volume.
struct Cubes {
  Grid grid;
  Region region;
};

Cubes cubes() {
  Cubes two;
  two.grid.dims = {12, 10, 9};
  two.grid.spacingMm = glm::dvec3(1.5);
  two.grid.originMm = {-7.0, 3.0, 20.0};
  std::vector<std::uint8_t> places(12 * 10 * 9, 0);
  const auto fill = [&](const glm::ivec3& lower, int size, std::uint8_t place) {
    for (int z = lower.z; z < lower.z + size; ++z)
      for (int y = lower.y; y < lower.y + size; ++y)
        for (int x = lower.x; x < lower.x + size; ++x)
          places[voxelOffset(two.grid.dims, x, y, z)] = place;
  };
  fill({4, 3, 3}, 4, 1);
  fill({0, 0, 0}, 2, 2);
  two.region = {
      Region::Kind::labels,
      "seg",
      std::make_shared<const LabelMap>(
          two.grid.dims, places,
          std::vector<Label>{
              {0, "Background", {}}, {1, "liver", {}}, {2, "a/b: c", {}}, {3, "liver", {}}, {4, "gone", {}}}),
      {1.0, 1.0, 1.0, 1.0, 1.0}};
  return two;
}

TEST(LabelSurfaces, haveAFileEachThatIsCalledAfterTheLabel) {
  Cubes two = cubes();
  std::vector<LabelSurface> surfaces = labelSurfaces(two.region, "/tmp/organs.stl");
  ASSERT_EQ(surfaces.size(), 2u) << "not the background, and none without voxels";
  EXPECT_EQ(surfaces[0].file, "/tmp/organs_liver.stl");
  EXPECT_EQ(surfaces[1].file, "/tmp/organs_a_b__c.stl");
  EXPECT_EQ(surfaces[1].name, "a/b: c");
  EXPECT_EQ(surfaces[1].place, 2u);
  std::vector<Label> labels = two.region.labels->labels();
  labels[2].name = "liver";
  two.region.labels = std::make_shared<const LabelMap>(two.grid.dims, two.region.labels->places(), labels);
  EXPECT_EQ(labelSurfaces(two.region, "organs.ply")[1].file, "organs_liver_2.ply");
}

TEST(LabelSurfaces, lieWhereTheLabelWeighsAHalf) {
  const Cubes two = cubes();
  SurfaceOrder order;
  order.isovalue = 0.5;
  const MadeSurface made = makeSurface(sceneOfLabel(two.region, 1, two.grid), order);
  EXPECT_TRUE(made.edges.isWatertight());
  EXPECT_EQ(made.parts, 1u);
  // The weight is a half midway between a voxel of the label and one beside it: 4 voxels of 1.5 mm from the
  // centre of the first minus half a voxel on. At edges and corners of the cube it falls faster.
  glm::dvec3 lowest(1e9), highest(-1e9);
  for (const glm::vec3& point : made.mesh.points) {
    lowest = glm::min(lowest, glm::dvec3(point));
    highest = glm::max(highest, glm::dvec3(point));
    // Each point is one of weight a half; triangles have points of single precision, of numbers below 40.
    EXPECT_NEAR(weightAt({Region::Kind::labels, "", two.region.labels, {0, 1, 0, 0, 0}},
                         worldToIndex(two.grid, glm::dvec3(point))),
                0.5, 1e-5);
  }
  const glm::dvec3 from = indexToWorld(two.grid, glm::dvec3(3.5, 2.5, 2.5));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(lowest[axis], from[axis], 1e-5);
    EXPECT_NEAR(highest[axis], from[axis] + 6.0, 1e-5);
  }
  EXPECT_LT(made.enclosedMm3, 216.0);
  EXPECT_GT(made.enclosedMm3, 0.85 * 216.0);
}

TEST(LabelSurfaces, areWrittenEach) {
  const Cubes two = cubes();
  const test::TemporaryFolder folder;
  const std::vector<LabelSurface> surfaces = labelSurfaces(two.region, folder.path() / "o.stl");
  std::vector<double> told;
  const std::vector<WrittenSurface> written = exportLabelSurfaces(
      two.region, two.grid, surfaces, {}, {[&](double done, const Message&) { told.push_back(done); }, {}});
  ASSERT_EQ(written.size(), 2u);
  for (const WrittenSurface& one : written) {
    EXPECT_TRUE(std::filesystem::is_regular_file(one.file)) << one.file;
    EXPECT_TRUE(one.made.edges.isWatertight()) << "at the corner of the volume, too";
    // STL: 84 bytes and 50 for each triangle.
    EXPECT_EQ(std::filesystem::file_size(one.file), 84 + 50 * one.made.mesh.triangles.size());
  }
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_THROW((void)exportLabelSurfaces(two.region, two.grid, surfaces, {}, {{}, [] { return true; }}),
               Cancelled);
}

} // namespace
} // namespace limn
