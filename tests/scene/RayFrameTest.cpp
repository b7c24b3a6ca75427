// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/RayFrame.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

Grid tiltedGrid() {
  Grid grid;
  grid.dims = {40, 30, 20};
  grid.spacingMm = {0.5, 0.75, 2.0};
  grid.originMm = {100.0, -30.0, 12.0};
  // A rotation about z by the angle with cosine 0.6, and a reflection of the last axis: left-handed.
  grid.direction = {{0.6, 0.8, 0.0}, {-0.8, 0.6, 0.0}, {0.0, 0.0, -1.0}};
  return grid;
}

// The point at t mm from the eye along a framed ray, in world millimetres.
glm::dvec3 pointFromEye(const FramedRay& ray, const Grid& grid, double mm) {
  return indexToWorld(grid, ray.anchor + (ray.eye + mm) * ray.direction + centreIndex(grid));
}

TEST(RayFrame, raysAreThoseOfTheCameraInEitherProjection) {
  const Grid grid = tiltedGrid();
  const glm::ivec2 size(31, 17);
  Camera camera = defaultCamera(grid);
  camera.position += glm::dvec3(20.0, -10.0, 35.0);
  for (const Camera::Projection projection :
       {Camera::Projection::perspective, Camera::Projection::orthographic}) {
    camera.projection = projection;
    const RayFrame frame = rayFrame(camera, grid, size);
    for (const glm::ivec2& pixel :
         {glm::ivec2(0, 0), glm::ivec2(30, 0), glm::ivec2(7, 16), glm::ivec2(15, 8)}) {
      const Ray expected = rayThroughPixel(camera, pixel.x, pixel.y, size);
      const FramedRay ray = framedRay(frame, pixel.x, pixel.y, size);
      for (const double mm : {0.0, 1.0, 250.0})
        EXPECT_LT(glm::distance(pointFromEye(ray, grid, mm), expected.origin + mm * expected.direction),
                  1e-10);
    }
  }
}

TEST(RayFrame, aCameraInsideTheBoxOrBehindItStartsAtItsEye) {
  const Grid grid = tiltedGrid();
  Camera camera = defaultCamera(grid);
  for (const double back : {-0.4, 0.1, 3.0}) {
    camera.target = boxCentreMm(grid);
    camera.position = camera.target - back * glm::dvec3(0.0, 1.0, 0.0);
    if (back < 0.0)
      camera.target.y += 10.0;
    const FramedRay ray = framedRay(rayFrame(camera, grid, {1, 1}), 0, 0, {1, 1});
    EXPECT_LE(ray.eye, 0.0);
    EXPECT_LT(glm::distance(pointFromEye(ray, grid, 0.0), camera.position), 1e-10);
    EXPECT_DOUBLE_EQ(spanInBox(ray, croppedBox(grid, {})).begin, ray.eye);
  }
}

// Rounded to floats, a ray's place in the box is as good as its anchor is near: where a picture of 170° is
// taken from within, its corner's ray (86° off the axis for a square) meets a plane half a box ahead 8 boxes
// aside.
TEST(RayFrame, wideRaysFromWithinTheBoxAreAnchoredInIt) {
  const Grid grid = tiltedGrid();
  Camera camera = defaultCamera(grid);
  camera.fovYDeg = 170.0;
  camera.position = boxCentreMm(grid) + glm::dvec3(3.0, -7.0, 2.0);
  const glm::ivec2 size(16, 16);
  const FramedRay ray = framedRay(rayFrame(camera, grid, size), 0, 0, size);
  EXPECT_TRUE(glm::all(glm::lessThan(glm::abs(ray.anchor), glm::dvec3(grid.dims))));
  EXPECT_LT(glm::distance(pointFromEye(ray, grid, 0.0), camera.position), 1e-10);
}

TEST(RayFrame, theBoxIsHalfOpenForRaysInItsFaces) {
  const IndexBox box{glm::dvec3(-2.0), glm::dvec3(2.0)};
  const auto isHit = [&box](const glm::dvec3& anchor) {
    return !spanInBox({anchor, {0.0, 1.0, 0.0}, -100.0}, box).isEmpty();
  };
  EXPECT_TRUE(isHit({-2.0, 0.0, 0.0}));
  EXPECT_FALSE(isHit({2.0, 0.0, 0.0}));
  EXPECT_TRUE(isHit({0.0, 0.0, -2.0}));
  EXPECT_FALSE(isHit({0.0, 0.0, 2.0}));
  EXPECT_FALSE(isHit({-2.1, 0.0, 0.0}));
}

TEST(RayFrame, nothingBehindTheEyeIsInTheSpan) {
  const IndexBox box{glm::dvec3(-2.0), glm::dvec3(2.0)};
  const RaySpan span = spanInBox({glm::dvec3(0.0), {0.0, 1.0, 0.0}, -0.5}, box);
  EXPECT_EQ(span.begin, -0.5);
  EXPECT_EQ(span.end, 2.0);
  EXPECT_TRUE(spanInBox({glm::dvec3(0.0), {0.0, 1.0, 0.0}, 3.0}, box).isEmpty());
}

TEST(SampleCount, aWholeNumberOfStepsGetsNoneMoreByRounding) {
  EXPECT_EQ(sampleCount(10.0, 1.0), 10);
  EXPECT_EQ(sampleCount(10.0 * (1.0 + 1e-9), 1.0), 10);
  EXPECT_EQ(sampleCount(10.001, 1.0), 11);
  EXPECT_EQ(sampleCount(0.1 + 0.2, 0.1), 3); // 0.30000000000000004 / 0.1
}

TEST(SampleCount, atLeastOneAndAtMostTheLimit) {
  EXPECT_EQ(sampleCount(1e-12, 1.0), 1);
  EXPECT_EQ(sampleCount(1.0, 1e-9), mostSamples);
}

TEST(CutPlanes, onlyFacesThatCutHaveOne) {
  const Grid grid = tiltedGrid();
  const CutPlanes planes = cutPlanes(grid, {{0.25, 0.0, 0.0}, {1.0, 1.0, 0.5}});
  EXPECT_DOUBLE_EQ(planes.lower.x, -10.0);
  EXPECT_DOUBLE_EQ(planes.upper.z, 0.0);
  EXPECT_LT(planes.lower.y, -1e8);
  EXPECT_GT(planes.upper.x, 1e8);
}

} // namespace
} // namespace limn
