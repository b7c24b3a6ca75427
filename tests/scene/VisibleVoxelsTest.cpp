// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/framing/VisibleVoxels.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// A box of 100 in a field of 0, opaque from 50 on.
Scene sceneWithBox(const glm::ivec3& dims, const glm::ivec3& lower, const glm::ivec3& upper) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {0.5, 0.7, 1.5};
  grid.originMm = {-20.0, 31.0, 7.0};
  std::vector<std::int16_t> voxels(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 0);
  for (int z = lower.z; z < upper.z; ++z)
    for (int y = lower.y; y < upper.y; ++y)
      for (int x = lower.x; x < upper.x; ++x)
        voxels[voxelOffset(dims, x, y, z)] = 100;
  Scene scene;
  scene.volume = std::make_shared<Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{});
  scene.transferFunction.points = {{49.0, glm::dvec3(1.0), 0.0}, {50.0, glm::dvec3(1.0), 0.5}};
  scene.camera = defaultCamera(grid);
  return scene;
}

// In voxel indices: the volume fills [-0.5, n-0.5).
void expectBox(const Scene& scene, const glm::dvec3& lower, const glm::dvec3& upper) {
  const IndexBox box = visibleBox(scene);
  const glm::dvec3 centre = centreIndex(scene.volume->grid());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(box.lower[axis] + centre[axis], lower[axis], 1e-12) << axis;
    EXPECT_NEAR(box.upper[axis] + centre[axis], upper[axis], 1e-12) << axis;
  }
}

TEST(VisibleBox, isTheBoxOfWhatIsOpaqueOneVoxelWider) {
  // Voxels 5..11 own [4.5, 11.5); one more on each side.
  expectBox(sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8}), {3.5, 4.5, 5.5}, {12.5, 9.5, 8.5});
}

TEST(VisibleBox, endsWithTheVolume) {
  expectBox(sceneWithBox({30, 20, 16}, {0, 6, 7}, {30, 20, 8}), {-0.5, 4.5, 5.5}, {29.5, 19.5, 8.5});
}

TEST(VisibleBox, isAllOfTheVolumeWhereNothingShows) {
  Scene scene = sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8});
  scene.transferFunction.points = {{0.0, glm::dvec3(1.0), 0.019}};
  expectBox(scene, {-0.5, -0.5, -0.5}, {29.5, 19.5, 15.5});
  // The definition's limit itself is visible.
  scene.transferFunction.points = {{60.0, glm::dvec3(1.0), 0.0}, {100.0, glm::dvec3(1.0), 0.02}};
  expectBox(scene, {3.5, 4.5, 5.5}, {12.5, 9.5, 8.5});
}

TEST(VisibleBox, followsTheCrop) {
  Scene scene = sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8});
  // Half of the box along x begins at index 14.5: what is opaque lies before it.
  scene.crop.upper.x = 0.25; // [-0.5, 7)
  expectBox(scene, {3.5, 4.5, 5.5}, {7.0, 9.5, 8.5});
  scene.crop = {};
  scene.crop.lower.x = 0.5;
  expectBox(scene, {14.5, -0.5, -0.5}, {29.5, 19.5, 15.5});
}

TEST(CropsOnlyUnseen, tellsAirFromWhatIsSeenHoweverFaint) {
  const Scene whole = sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8});
  EXPECT_TRUE(cropsOnlyUnseen(whole)) << "nothing is cropped";
  const glm::dvec3 dims(30.0, 20.0, 16.0);
  // One voxel beside what is seen on each side: half of it is what its outermost voxels are interpolated to.
  const CropBox around{glm::dvec3(4, 5, 6) / dims, glm::dvec3(13, 10, 9) / dims};
  Scene cropped = whole;
  cropped.crop = around;
  EXPECT_TRUE(cropsOnlyUnseen(cropped));
  cropped.transferFunction.points = {{49.0, glm::dvec3(1.0), 0.0}, {50.0, glm::dvec3(1.0), 0.001}};
  EXPECT_TRUE(cropsOnlyUnseen(cropped));
  // Each face that comes nearer takes a part of it, also of what is too faint to be framed on.
  for (const double opacity : {0.5, 0.001})
    for (int axis = 0; axis < 3; ++axis)
      for (const bool isUpper : {false, true}) {
        cropped = whole;
        cropped.transferFunction.points[1].opacity = opacity;
        cropped.crop = around;
        (isUpper ? cropped.crop.upper : cropped.crop.lower)[axis] += (isUpper ? -1.0 : 1.0) / dims[axis];
        EXPECT_FALSE(cropsOnlyUnseen(cropped)) << axis << isUpper << " at " << opacity;
      }
}

// What lies low on a wide ramp is far below what a picture is framed on, and adds up along a ray.
TEST(CropsOnlyUnseen, knowsWhatIsFaintByARamp) {
  Scene scene = sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8});
  scene.crop.lower.x = 0.5; // behind all of the box
  scene.transferFunction.points = {{0.0, glm::dvec3(1.0), 0.0}, {3e4, glm::dvec3(1.0), 0.8}};
  EXPECT_FALSE(cropsOnlyUnseen(scene));
}

TEST(CropsOnlyUnseen, knowsWhatIsHiddenAlreadyAndWhereAirCounts) {
  Scene scene = sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8});
  scene.crop.lower.x = 0.5; // behind all of the box
  EXPECT_FALSE(cropsOnlyUnseen(scene));
  std::vector<std::uint8_t> places(30 * 20 * 16, 0);
  places[voxelOffset({30, 20, 16}, 20, 7, 7)] = 1;
  scene.keep = bodyRegion({30, 20, 16}, places);
  EXPECT_TRUE(cropsOnlyUnseen(scene)) << "the kept region leaves nothing there";
  for (const Projection projection : {Projection::minip, Projection::average}) {
    scene.projection = projection;
    EXPECT_FALSE(cropsOnlyUnseen(scene));
  }
  // The largest of a ray hides what shows where the curve hides it.
  scene.projection = Projection::mip;
  EXPECT_TRUE(cropsOnlyUnseen(scene));
  scene.transferFunction.points.push_back({200.0, glm::dvec3(1.0), 0.0});
  EXPECT_FALSE(cropsOnlyUnseen(scene));
  // A surface is seen by its value, whatever the curve makes of it.
  scene.keep = {};
  scene.projection = Projection::isosurface;
  scene.transferFunction.points.clear();
  scene.isovalue = 50.0;
  EXPECT_FALSE(cropsOnlyUnseen(scene));
  scene.isovalue = 101.0;
  EXPECT_TRUE(cropsOnlyUnseen(scene));
}

TEST(VisibleBox, followsTheKeptRegion) {
  Scene scene = sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8});
  std::vector<std::uint8_t> places(30 * 20 * 16, 0);
  places[voxelOffset({30, 20, 16}, 8, 7, 7)] = 1;
  scene.keep = bodyRegion({30, 20, 16}, places);
  expectBox(scene, {6.5, 5.5, 5.5}, {9.5, 8.5, 8.5});
  // A weight scales the opacity, 0.5 here.
  scene.keep.weights = {0.03, 1.0};
  expectBox(scene, {6.5, 5.5, 5.5}, {9.5, 8.5, 8.5});
  scene.keep.weights = {0.041, 1.0};
  expectBox(scene, {3.5, 4.5, 5.5}, {12.5, 9.5, 8.5});
}

TEST(VisibleBox, holdsWhatReachesTheIsovalueWhereASurfaceIsShown) {
  Scene scene = sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8});
  scene.transferFunction.points.clear();
  scene.projection = Projection::isosurface;
  scene.isovalue = 100.0;
  expectBox(scene, {3.5, 4.5, 5.5}, {12.5, 9.5, 8.5});
  scene.isovalue = 100.5;
  expectBox(scene, {-0.5, -0.5, -0.5}, {29.5, 19.5, 15.5});
}

TEST(VisibleBox, doesNotDependOnTheStoredType) {
  const Scene small = sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8});
  const auto& stored = std::get<StoredVoxels<std::int16_t>>(small.volume->stored());
  Scene large = small;
  // A falling rescale: what is stored as the lowest is the highest.
  std::vector<float> floats(stored.size());
  std::transform(stored.begin(), stored.end(), floats.begin(), [](int v) { return -static_cast<float>(v); });
  large.volume =
      std::make_shared<Volume>(small.volume->grid(), floats, Rescale{-1.0, 0.0}, std::nullopt, VolumeInfo{});
  expectBox(large, {3.5, 4.5, 5.5}, {12.5, 9.5, 8.5});
}

TEST(VisibleBox, canBeCancelled) {
  const Scene scene = sceneWithBox({30, 20, 16}, {5, 6, 7}, {12, 9, 8});
  Effort effort;
  effort.isCancelled = [] { return true; };
  EXPECT_THROW(visibleBox(scene, effort), Cancelled);
}

} // namespace
} // namespace limn
