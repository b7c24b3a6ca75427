// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/Session.h"

#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(SceneEdits, theTargetPlaneKeepsItsSizeWithParallelRaysAndBack) {
  Camera camera;
  camera.position = {0.0, -300.0, 0.0};
  camera.target = {0.0, 0.0, 0.0};
  camera.fovYDeg = 90.0;
  const Camera parallel = withProjection(camera, Camera::Projection::orthographic);
  EXPECT_NEAR(parallel.heightMm, 600.0, 1e-9); // 2 · 300 mm · tan 45°
  const Camera back = withProjection(parallel, Camera::Projection::perspective);
  EXPECT_NEAR(glm::length(back.position - camera.position), 0.0, 1e-9);
  EXPECT_EQ(withProjection(parallel, Camera::Projection::orthographic), parallel);
}

TEST(SceneEdits, onlyASurfaceAtAValueThatIsNotThereMoves) {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 8.0});
  const Histogram histogram = histogramOf(*scene.volume);
  scene.isovalue = 1e6;
  EXPECT_EQ(withProjection(scene, Projection::mip, histogram).isovalue, 1e6);
  const double moved = withProjection(scene, Projection::isosurface, histogram).isovalue;
  EXPECT_GT(moved, scene.volume->range().lowest);
  EXPECT_LT(moved, scene.volume->range().highest);
  scene.isovalue = 123.5;
  EXPECT_EQ(withProjection(scene, Projection::isosurface, histogram).isovalue, 123.5);
}

} // namespace
} // namespace limn
