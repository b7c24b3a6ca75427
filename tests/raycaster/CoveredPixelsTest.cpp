// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/PixelRect.h"
#include "scene/view/Camera.h"

#include <gtest/gtest.h>

#include <random>

namespace limn {
namespace {

constexpr glm::ivec2 coveredSize(48, 31);

Grid grid() {
  Grid grid;
  grid.dims = {20, 31, 12};
  grid.spacingMm = {1.0, 0.7, 2.0};
  grid.originMm = {-40.0, 12.0, 5.0};
  grid.direction[0] = -grid.direction[0];
  return grid;
}

bool contains(const PixelRect& rect, const glm::ivec2& pixel) {
  return glm::all(glm::greaterThanEqual(pixel, rect.topLeft)) &&
         glm::all(glm::lessThan(pixel, rect.topLeft + rect.size));
}

// The pixels whose rays meet the box; fails where the rectangle lacks one.
int expectAllCovered(const Camera& camera, const IndexBox& box) {
  const PixelRect rect = coveredPixels(camera, grid(), box, coveredSize);
  const RayFrame frame = rayFrame(camera, grid(), coveredSize);
  int covered = 0;
  for (int y = 0; y < coveredSize.y; ++y)
    for (int x = 0; x < coveredSize.x; ++x)
      if (!spanInBox(framedRay(frame, x, y, coveredSize), box).isEmpty()) {
        EXPECT_TRUE(contains(rect, {x, y})) << x << ", " << y;
        ++covered;
      }
  return covered;
}

TEST(CoveredPixels, holdEveryPixelWhoseRayMeetsTheBoxFromAnywhere) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&] { return glm::dvec3(unit(generator), unit(generator), unit(generator)); };
  int covered = 0;
  for (int i = 0; i < 300; ++i) {
    Camera camera = defaultCamera(grid());
    camera.projection = i % 3 == 0 ? Camera::Projection::orthographic : Camera::Projection::perspective;
    // From inside the box to ten times its size away.
    camera.position = camera.target + std::pow(10.0, 1.5 + unit(generator)) * vector();
    camera.target += 10.0 * vector();
    camera.up = vector();
    camera.fovYDeg = 50.0 + 45.0 * unit(generator);
    camera.heightMm = 60.0;
    IndexBox box = croppedBox(grid(), {});
    if (i % 2 == 0)
      box = croppedBox(grid(), {{0.2, 0.1, 0.3}, {0.5, 0.9, 0.6}});
    covered += expectAllCovered(camera, box);
  }
  EXPECT_GT(covered, 10000);
}

TEST(CoveredPixels, areFewMoreThanTheBoxTakes) {
  const IndexBox box = croppedBox(grid(), {});
  // The default camera leaves a wide margin around the box.
  const PixelRect rect = coveredPixels(defaultCamera(grid()), grid(), box, coveredSize);
  EXPECT_LT(rect.size.x * rect.size.y, coveredSize.x * coveredSize.y / 2);
}

TEST(CoveredPixels, ofAnEmptyBoxThereAreNone) {
  const PixelRect rect =
      coveredPixels(defaultCamera(grid()), grid(), {glm::dvec3(1.0), glm::dvec3(1.0)}, coveredSize);
  EXPECT_EQ(rect.size, glm::ivec2(0));
}

} // namespace
} // namespace limn
