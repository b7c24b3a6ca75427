// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/ViewDrag.h"

#include "widgets/view/overlay/OrientationMarks.h"
#include "widgets/view/overlay/ViewGeometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace limn {
namespace {

const Camera front{.position = {0, -100, 0}, .target = {0, 0, 0}, .up = {0, 0, 1}};
const QRectF dragPlace(0, 0, 400, 200);

void expectNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(DragKind, followsTheTableOfMouseActions) {
  const auto left = [](Qt::KeyboardModifiers modifiers, ViewTool tool = ViewTool::rotate) {
    return dragKind(Qt::LeftButton, modifiers, tool);
  };
  EXPECT_EQ(left(Qt::NoModifier), DragKind::rotate);
  EXPECT_EQ(left(Qt::ShiftModifier), DragKind::pan);
  EXPECT_EQ(left(Qt::ControlModifier), DragKind::roll);
  EXPECT_EQ(left(Qt::AltModifier), DragKind::windowLevel);
  EXPECT_EQ(left(Qt::AltModifier | Qt::ControlModifier), DragKind::opacity);
  EXPECT_EQ(left(Qt::NoModifier, ViewTool::windowLevel), DragKind::windowLevel);
  EXPECT_EQ(left(Qt::AltModifier | Qt::ControlModifier, ViewTool::windowLevel), DragKind::opacity);
  EXPECT_EQ(left(Qt::NoModifier, ViewTool::pan), DragKind::pan);
  EXPECT_EQ(left(Qt::NoModifier, ViewTool::zoom), DragKind::zoom);
  EXPECT_EQ(dragKind(Qt::MiddleButton, Qt::NoModifier, ViewTool::rotate), DragKind::pan);
  EXPECT_EQ(dragKind(Qt::RightButton, Qt::NoModifier, ViewTool::rotate), DragKind::zoom);
  EXPECT_EQ(dragKind(Qt::BackButton, Qt::NoModifier, ViewTool::rotate), DragKind::none);
}

TEST(CameraGesture, draggingRightByHalfTheHeightTurnsTheFrontToTheRight) {
  // Half the height is a quarter turn: the camera goes to the patient's right, -x, so that the front
  // surface moves to the right of the picture.
  const Camera camera = dragged(front, DragKind::rotate, {100, 100}, {200, 100}, dragPlace);
  expectNear(camera.position, {-100, 0, 0}, 1e-9);
}

TEST(CameraGesture, draggingUpShowsMoreOfTheLowerSide) {
  const Camera camera = dragged(front, DragKind::rotate, {100, 100}, {100, 90}, dragPlace);
  EXPECT_LT(camera.position.z, 0.0);
  EXPECT_NEAR(camera.position.x, 0.0, 1e-12);
}

TEST(CameraGesture, draggingAroundAndBackReturns) {
  Camera camera = dragged(front, DragKind::rotate, {0, 0}, {30, 0}, dragPlace);
  camera = dragged(camera, DragKind::rotate, {30, 0}, {0, 0}, dragPlace);
  expectNear(camera.position, front.position, 1e-9);
}

// A place that is turned about keeps its pixel and its distance, whatever is turned; without one nothing is
// new.
TEST(CameraGesture, aTurnAboutAPlaceKeepsThatPlaceUnderItsPixel) {
  const glm::dvec3 place(12, -30, 7);
  for (const auto projection : {Camera::Projection::perspective, Camera::Projection::orthographic}) {
    Camera before = orbited(front, 0.4, -0.2);
    before.projection = projection;
    const Camera after = dragged(before, DragKind::rotate, {100, 100}, {170, 60}, dragPlace, place);
    const auto was = pixelOf(viewProjection(before, dragPlace), place);
    const auto is = pixelOf(viewProjection(after, dragPlace), place);
    ASSERT_TRUE(was && is);
    // Rounding of sums of hundreds of millimetres, in pixels of about a millimetre.
    EXPECT_NEAR(is->x(), was->x(), 1e-9);
    EXPECT_NEAR(is->y(), was->y(), 1e-9);
    EXPECT_NEAR(glm::length(after.position - place), glm::length(before.position - place), 1e-9);
    EXPECT_NEAR(glm::length(after.position - after.target), 100.0, 1e-9);
    const Camera plain = dragged(before, DragKind::rotate, {100, 100}, {170, 60}, dragPlace);
    expectNear(basisOf(after).forward, basisOf(plain).forward, 1e-12);
    expectNear(basisOf(after).up, basisOf(plain).up, 1e-12);
    EXPECT_EQ(plain.target, before.target);
  }
  expectNear(orbitedAbout(front, 0.3, 0.2, front.target).position, orbited(front, 0.3, 0.2).position, 1e-9);
}

// Zoomed into a part, the place may have come to lie behind the eye: turning about it would lead what is seen
// against the pointer.
TEST(CameraGesture, aTurnAboutWhatLiesBehindTheEyeGoesAboutTheTarget) {
  const glm::dvec3 ahead = front.target - 40.0 * basisOf(front).forward;
  const Camera near = zoomed(front, 4.0); // 25 mm before the target
  for (const double behind : {30.0, 0.0}) {
    const glm::dvec3 place = near.position - behind * basisOf(near).forward;
    Comparison comparison;
    comparison.scene.camera = near;
    comparison.turnsAboutMm = place;
    const ViewGeometry geometry{CompareLayout::single, 0.5, {400, 200}, 1.0};
    const ViewDrag drag =
        dragFrom({Qt::LeftButton, Qt::NoModifier, {100, 100}}, comparison, geometry, ViewTool::rotate, {});
    EXPECT_FALSE(drag.turnsAbout) << behind;
  }
  EXPECT_EQ(centreBeforeEye(front, ahead), ahead);
  EXPECT_FALSE(centreBeforeEye(near, ahead)) << "15 mm behind it";
  EXPECT_EQ(centreBeforeEye(front, ahead), ahead) << "and comes back with the distance";
}

TEST(CameraGesture, panningKeepsThePointOfTheTargetPlaneUnderThePointer) {
  const Camera camera = dragged(front, DragKind::pan, {200, 100}, {250, 80}, dragPlace);
  // The picture is 2 · 100 mm · tan 15° high for 200 pixels; the target moves against the pointer.
  const double mmPerPixel = 200.0 * std::tan(15.0 * 3.14159265358979323846 / 180.0) / 200.0;
  expectNear(camera.target, {-50 * mmPerPixel, 0, -20 * mmPerPixel}, 1e-9);
  expectNear(camera.position - camera.target, front.position - front.target, 1e-9);
}

TEST(CameraGesture, zoomingUpComesNearerAndBackReturns) {
  const Camera near = dragged(front, DragKind::zoom, {0, 100}, {0, 50}, dragPlace);
  // A quarter of the height is e^0.5.
  EXPECT_NEAR(near.position.y, -100.0 / std::exp(0.5), 1e-9);
  expectNear(dragged(near, DragKind::zoom, {0, 50}, {0, 100}, dragPlace).position, front.position, 1e-9);
}

TEST(CameraGesture, rollFollowsThePointerAroundTheCentre) {
  // From the right of the centre to below it: a quarter turn clockwise, so that up comes to point right.
  const Camera camera = dragged(front, DragKind::roll, {300, 100}, {200, 180}, dragPlace);
  const CameraBasis basis = basisOf(camera);
  expectNear(basis.right, {0, 0, 1}, 1e-9);
}

TEST(CameraGesture, rollAcrossTheNegativeAxisTakesTheShortWay) {
  const Camera camera = dragged(front, DragKind::roll, {100, 99}, {100, 101}, dragPlace);
  // Two pixels at a hundred pixels from the centre are about 0.02 radians.
  EXPECT_GT(glm::dot(basisOf(camera).up, basisOf(front).up), 0.999);
}

TEST(CameraGesture, aNotchOfTheWheelIsAFifth) {
  EXPECT_NEAR(wheelZoomed(front, 120).position.y, -100.0 / 1.2, 1e-9);
  EXPECT_NEAR(wheelZoomed(front, -120).position.y, -120.0, 1e-9);
}

// Where a place of the target's plane is seen, as a fraction of the picture's height.
glm::dvec2 seenAt(const Camera& camera, const glm::dvec3& place) {
  const CameraBasis basis = basisOf(camera);
  const glm::dvec3 from = place - camera.target;
  const double height =
      2.0 * glm::length(camera.target - camera.position) * std::tan(0.5 * glm::radians(camera.fovYDeg));
  return glm::dvec2(glm::dot(from, basis.right), glm::dot(from, basis.up)) / height;
}

TEST(CameraGesture, theWheelZoomsTowardsThePointer) {
  // A quarter of the height right of the centre, a tenth above it.
  const QPointF pointer = dragPlace.center() + QPointF(0.25, -0.1) * dragPlace.height();
  const double height = 200.0 * std::tan(0.5 * glm::radians(front.fovYDeg));
  const CameraBasis basis = basisOf(front);
  const glm::dvec3 place = front.target + height * (0.25 * basis.right + 0.1 * basis.up);
  ASSERT_NEAR(seenAt(front, place).x, 0.25, 1e-9);
  for (const int turn : {120, 360, -120}) {
    const Camera camera = wheelZoomed(front, turn, pointer, dragPlace);
    EXPECT_NEAR(seenAt(camera, place).x, 0.25, 1e-9) << turn;
    EXPECT_NEAR(seenAt(camera, place).y, 0.1, 1e-9) << turn;
    EXPECT_NEAR(glm::length(camera.position - camera.target), 100.0 * std::pow(1.2, -turn / 120.0), 1e-9);
  }
  expectNear(wheelZoomed(wheelZoomed(front, 240, pointer, dragPlace), -240, pointer, dragPlace).target,
             front.target, 1e-9);
}

TEST(CameraGesture, nearestStandardViewOfEveryStandardViewIsItself) {
  Grid grid;
  grid.dims = {10, 10, 10};
  for (const StandardView view : {StandardView::anterior, StandardView::posterior, StandardView::left,
                                  StandardView::right, StandardView::superior, StandardView::inferior}) {
    const Camera camera = orbited(standardView(front, grid, view), 0.3, -0.3);
    EXPECT_EQ(nearestStandardView(camera), view);
  }
}

} // namespace
} // namespace limn
