// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/Camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace limn {
namespace {

const glm::dvec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

TEST(Camera, basisIsOrthonormalForEveryAxisAndUp) {
  for (const glm::dvec3& forward : axes)
    for (const glm::dvec3& up : axes) {
      const CameraBasis basis =
          basisOf({.position = {3, 4, 5}, .target = glm::dvec3(3, 4, 5) + forward, .up = up});
      const glm::dmat3 m(basis.right, basis.up, -basis.forward);
      EXPECT_NEAR(glm::determinant(m), 1.0, 1e-12);
    }
}

TEST(Camera, basisIsFiniteWherePositionEqualsTarget) {
  const CameraBasis basis = basisOf({.position = {1, 1, 1}, .target = {1, 1, 1}, .up = {0, 0, 0}});
  EXPECT_NEAR(glm::length(basis.right), 1.0, 1e-12);
}

TEST(Camera, defaultLooksAtThePatientsFaceWithTheWholeBoxInView) {
  Grid grid;
  grid.dims = {10, 20, 30};
  const Camera camera = defaultCamera(grid);
  // A sphere of the box's diagonal 2 R fills 30° with a tenth to spare: 1.1 · R / sin 15°.
  const double distance = 1.1 * std::sqrt(1400.0) / 2.0 / std::sin(std::numbers::pi / 12.0);
  EXPECT_NEAR(camera.position.y, 9.5 - distance, 1e-9);
  EXPECT_NEAR(camera.target.x, 4.5, 1e-12);
  // The patient's left (+x in LPS) is on the right of the picture.
  EXPECT_NEAR(basisOf(camera).right.x, 1.0, 1e-12);
}

TEST(Camera, centrePixelOfAnOddPictureLooksAlongForward) {
  const Camera camera{.position = {0, -10, 0}, .target = {0, 0, 0}};
  const Ray ray = rayThroughPixel(camera, 2, 2, {5, 5});
  EXPECT_NEAR(ray.direction.y, 1.0, 1e-15);
}

TEST(Camera, orbitKeepsTheDistanceAndAFullTurnReturns) {
  Camera camera{.position = {0, -10, 3}, .target = {1, 2, 3}};
  const double distance = glm::length(camera.position - camera.target);
  Camera turned = camera;
  for (int i = 0; i < 8; ++i) {
    turned = orbited(turned, std::numbers::pi / 4.0, 0.0);
    EXPECT_NEAR(glm::length(turned.position - turned.target), distance, 1e-9);
  }
  EXPECT_NEAR(glm::length(turned.position - camera.position), 0.0, 1e-9);
}

TEST(Camera, pitchPassesThePoleWithoutAJump) {
  Camera camera{.position = {0, -10, 0}, .target = {0, 0, 0}};
  CameraBasis before = basisOf(camera);
  for (int i = 0; i < 360; ++i) {
    camera = orbited(camera, 0.0, std::numbers::pi / 180.0);
    const CameraBasis after = basisOf(camera);
    EXPECT_GT(glm::dot(before.up, after.up), 0.999);
    before = after;
  }
}

TEST(Camera, seesAPlaceOnTheRayThroughIt) {
  for (const auto projection : {Camera::Projection::perspective, Camera::Projection::orthographic}) {
    Camera camera{projection, {10.0, -300.0, 40.0}, {0.0, 0.0, 5.0}};
    const Ray pixel = rayThroughPixel(camera, 17, 80, {120, 90});
    const std::optional<Ray> through = rayThroughPlace(camera, pixel.origin + 250.0 * pixel.direction);
    ASSERT_TRUE(through);
    EXPECT_LT(glm::length(through->origin - pixel.origin), 1e-9);
    EXPECT_LT(glm::length(through->direction - pixel.direction), 1e-12);
  }
  EXPECT_FALSE(rayThroughPlace({}, Camera{}.position)) << "no direction leads into the eye";
}

} // namespace
} // namespace limn
