// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/Probe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

// Layers along y, 10 mm each, seen from the front: 0 | 100 | 500 | 0.
Scene layers() {
  Grid grid;
  grid.dims = {8, 40, 8};
  std::vector<float> voxels(8 * 40 * 8);
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 8; ++i)
        voxels[voxelOffset(grid.dims, i, j, k)] = j < 10 ? 0.0f : j < 20 ? 100.0f : j < 30 ? 500.0f : 0.0f;
  Scene scene;
  scene.volume = std::make_shared<Volume>(grid, VoxelArray(voxels), Rescale{}, std::nullopt, VolumeInfo{});
  scene.transferFunction.points = {{50, {1, 0, 0}, 0.0}, {100, {1, 0, 0}, 0.01}, {500, {1, 1, 1}, 0.5}};
  scene.camera = defaultCamera(grid);
  return scene;
}

const Ray throughTheMiddle{{3.5, -50.0, 3.5}, {0.0, 1.0, 0.0}};

TEST(Probe, findsTheDenseLayerBehindAThinOne) {
  const auto probe = probeAlong(layers(), {}, throughTheMiddle);
  ASSERT_TRUE(probe);
  // The ramp between the layers lies at 19..20; the first samples of 500 after it win, for T falls quickly.
  EXPECT_GT(probe->value, 300.0);
  EXPECT_NEAR(probe->positionMm.y, 20.0, 1.0);
  EXPECT_NEAR(probe->index.y, probe->positionMm.y, 1e-9);
}

TEST(Probe, findsTheThinLayerWhereItHidesTheDenseOne) {
  Scene scene = layers();
  scene.transferFunction.points[1].opacity = 0.95;
  const auto probe = probeAlong(scene, {}, throughTheMiddle);
  ASSERT_TRUE(probe);
  EXPECT_NEAR(probe->positionMm.y, 9.5, 1.0);
}

TEST(Probe, seesThroughWhatTheEnhancedModelHides) {
  Scene scene = layers();
  scene.transferFunction.points[1].opacity = 0.95;
  scene.shading.model = ShadingModel::enhanced;
  // Inside the thin layer the gradient and so O are 0; at its front, (100 - 0)/2 mm of 200, O is 0.75.
  scene.transferFunction.points[0].value = 99.0;
  const auto probe = probeAlong(scene, {200.0, 200.0}, throughTheMiddle);
  ASSERT_TRUE(probe);
  EXPECT_GT(probe->positionMm.y, 18.5);
}

TEST(Probe, findsNothingBesideTheVolumeOrInTransparency) {
  EXPECT_FALSE(probeAlong(layers(), {}, {{30.0, -50.0, 3.5}, {0.0, 1.0, 0.0}}));
  EXPECT_FALSE(probeAlong(layers(), {}, {{3.5, 80.0, 3.5}, {0.0, 1.0, 0.0}})); // looking away
  Scene transparent = layers();
  transparent.transferFunction.points.clear();
  EXPECT_FALSE(probeAlong(transparent, {}, throughTheMiddle));
  EXPECT_FALSE(probeAlong(Scene{}, {}, throughTheMiddle));
}

TEST(Probe, staysInsideTheCropBox) {
  Scene scene = layers();
  scene.crop.upper.y = 0.5; // the dense layer is cut away: index 19.5 and more
  const auto probe = probeAlong(scene, {}, throughTheMiddle);
  ASSERT_TRUE(probe);
  EXPECT_LT(probe->index.y, 19.5);
}

TEST(Probe, takesTheExtremeOfAProjectionOfExtremes) {
  Scene scene = layers();
  scene.projection = Projection::mip;
  EXPECT_EQ(probeAlong(scene, {}, throughTheMiddle)->value, 500.0);
  scene.projection = Projection::minip;
  EXPECT_EQ(probeAlong(scene, {}, throughTheMiddle)->value, 0.0);
}

// Of the layers the dense one is hidden: 20 to 29.
TEST(Probe, seesThroughWhatTheKeptRegionHides) {
  Scene scene = layers();
  const glm::ivec3 dims = scene.volume->grid().dims;
  std::vector<std::uint8_t> places;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      places.insert(places.end(), static_cast<std::size_t>(dims.x), j < 20 ? 1 : 0);
  scene.keep = bodyRegion(dims, places);
  const auto probe = probeAlong(scene, {}, throughTheMiddle);
  ASSERT_TRUE(probe);
  EXPECT_LT(probe->index.y, 20.0);
  scene.projection = Projection::mip;
  EXPECT_LT(probeAlong(scene, {}, throughTheMiddle)->index.y, 19.5);
  scene.projection = Projection::isosurface;
  scene.isovalue = 400.0; // reached at 19.75, where less than half is kept
  EXPECT_FALSE(probeAlong(scene, {}, throughTheMiddle));
}

TEST(Probe, takesTheFirstCrossingOfAnIsosurface) {
  Scene scene = layers();
  scene.projection = Projection::isosurface;
  scene.isovalue = 50.0;
  const auto probe = probeAlong(scene, {}, throughTheMiddle);
  ASSERT_TRUE(probe);
  EXPECT_NEAR(probe->positionMm.y, 9.5, 0.5); // half a voxel of step
  scene.isovalue = 600.0;
  EXPECT_FALSE(probeAlong(scene, {}, throughTheMiddle));
}

// The front half of the volume is a label, the back half another.
Scene labelledLayers() {
  Scene scene = layers();
  const glm::ivec3& dims = scene.volume->grid().dims;
  std::vector<std::uint8_t> places(8 * 40 * 8);
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 8; ++i)
        places[voxelOffset(dims, i, j, k)] = j < 20 ? 0 : 1;
  scene.keep = {
      Region::Kind::labels,
      "seg",
      std::make_shared<const LabelMap>(dims, places, std::vector<Label>{{1, "Front", {}}, {2, "Back", {}}}),
      {1.0, 1.0}};
  return scene;
}

TEST(Probe, seesALabelByItsOwnCurve) {
  Scene scene = labelledLayers();
  // The scene's curve shows nothing in front; by its own the thin layer there hides all behind.
  TransferFunction opaque = scene.transferFunction;
  opaque.points[1].opacity = 0.95;
  scene.keep = withLooks(scene.keep, {{0, opaque}});
  const auto probe = probeAlong(scene, {}, throughTheMiddle);
  ASSERT_TRUE(probe);
  EXPECT_NEAR(probe->positionMm.y, 9.5, 1.0);
  // And the other way round: what its own curve makes clear is seen through.
  Scene clear = labelledLayers();
  clear.transferFunction = opaque;
  TransferFunction nothing = opaque;
  for (ControlPoint& point : nothing.points)
    point.opacity = 0.0;
  clear.keep = withLooks(clear.keep, {{0, nothing}});
  const auto behind = probeAlong(clear, {}, throughTheMiddle);
  ASSERT_TRUE(behind);
  // Between the voxels of the two labels, 19 to 20, the share of the back's grows.
  EXPECT_GT(behind->positionMm.y, 18.9);
}

TEST(Probe, ofAHiddenLabelSeesNothingWhateverItsCurve) {
  Scene scene = labelledLayers();
  TransferFunction opaque = scene.transferFunction;
  opaque.points[1].opacity = 0.95;
  scene.keep = withLooks(scene.keep, {{0, opaque}});
  scene.keep.weights = {0.0, 1.0};
  const auto probe = probeAlong(scene, {}, throughTheMiddle);
  ASSERT_TRUE(probe);
  EXPECT_GT(probe->positionMm.y, 18.9);
}

} // namespace
} // namespace limn
