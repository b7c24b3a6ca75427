// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CropBoxOverlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

const QRectF picture(100.0, 20.0, 400.0, 300.0);

// 40 × 40 × 40 mm around the origin, the axes turned: the grid's x is the patient's y.
Grid turnedGrid() {
  Grid grid;
  grid.dims = {40, 20, 10};
  grid.spacingMm = {1.0, 2.0, 4.0};
  grid.direction = glm::dmat3(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  grid.originMm = -(grid.direction * (grid.spacingMm * (glm::dvec3(grid.dims) - 1.0) / 2.0));
  return grid;
}

Camera obliqueCamera(Camera::Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.position = {90.0, -120.0, 70.0};
  camera.heightMm = 80.0;
  return camera;
}

const CropHandle& handleOf(const CropBoxShape& shape, CropFace face) {
  return *std::find_if(shape.handles.begin(), shape.handles.end(),
                       [&](const CropHandle& handle) { return handle.face == face; });
}

class BothProjections : public testing::TestWithParam<Camera::Projection> {
protected:
  const Camera camera = obliqueCamera(GetParam());
  const ViewProjection projection = viewProjection(camera, picture);
  const Grid grid = turnedGrid();
};

TEST_P(BothProjections, aPixelAndTheRayThroughItMeet) {
  const glm::ivec2 size(400, 300);
  const Ray ray = rayThroughPixel(camera, 310, 40, size);
  const glm::dvec3 place = ray.origin + 77.0 * ray.direction;
  const auto pixel = pixelOf(projection, place);
  ASSERT_TRUE(pixel);
  // The pixel's centre, in a picture that begins at (100, 20). The bound is of rounding.
  EXPECT_NEAR(pixel->x(), 100.0 + 310.5, 1e-9);
  EXPECT_NEAR(pixel->y(), 20.0 + 40.5, 1e-9);
  const Ray back = rayThrough(projection, *pixel);
  EXPECT_NEAR(glm::length(back.origin - ray.origin), 0.0, 1e-9);
  EXPECT_NEAR(glm::length(back.direction - ray.direction), 0.0, 1e-12);
}

TEST_P(BothProjections, pixelsPerMmIsTheDerivativeOfThePixel) {
  const glm::dvec3 place(5.0, -7.0, 3.0);
  const glm::dvec3 along = glm::normalize(glm::dvec3(1.0, 2.0, -0.5));
  const double h = 1e-4;
  const QPointF difference =
      (*pixelOf(projection, place + h * along) - *pixelOf(projection, place - h * along)) / (2.0 * h);
  const QPointF derivative = pixelsPerMm(projection, place, along);
  // The central difference is off by h² times a third derivative of order 10⁻³ pixels/mm³, and by rounding.
  EXPECT_NEAR(derivative.x(), difference.x(), 1e-7);
  EXPECT_NEAR(derivative.y(), difference.y(), 1e-7);
}

TEST_P(BothProjections, aFaceDraggedToAPlaceOnItsAxisLiesThere) {
  CropBox crop;
  crop.lower = {0.1, 0.2, 0.3};
  crop.upper = {0.9, 0.7, 0.8};
  for (const CropFace face : cropFaces) {
    for (const double place : {0.05, 0.4, 0.95}) {
      // The handle's centre if the face lay there: the other axes keep their middle.
      CropBox moved = crop;
      (face.isUpper ? moved.upper : moved.lower)[face.axis] = place;
      const QPointF pointer = *pixelOf(projection, faceCentre(moved, grid, face));
      EXPECT_NEAR(placeUnder(crop, grid, face, projection, pointer), place, 1e-9);
    }
  }
}

TEST_P(BothProjections, aPointerBesideTheAxisCountsAtItsFoot) {
  const CropBox crop;
  const CropFace face{2, true};
  const QPointF on = *pixelOf(projection, faceCentre({glm::dvec3(0.0), {1.0, 1.0, 0.6}}, grid, face));
  const QPointF way = handleOf(cropBoxShape(crop, grid, projection), face).outward;
  const QPointF beside = on + 30.0 * QPointF(-way.y(), way.x());
  EXPECT_NEAR(placeUnder(crop, grid, face, projection, beside), 0.6, 1e-9);
}

TEST_P(BothProjections, threeFacesAreSeenAndThreeEdgesHidden) {
  const CropBoxShape shape = cropBoxShape({}, grid, projection);
  EXPECT_EQ(shape.edges.size(), 12u);
  EXPECT_EQ(shape.handles.size(), 6u);
  // From an oblique view three faces of a box are turned to the eye; the three edges at the far corner are
  // those between two of the others.
  EXPECT_EQ(
      std::count_if(shape.handles.begin(), shape.handles.end(), [](const auto& h) { return h.isHidden; }), 3);
  EXPECT_EQ(std::count_if(shape.edges.begin(), shape.edges.end(), [](const auto& e) { return e.isHidden; }),
            3);
  // The camera stands at +x, -y, +z: it sees the left side (+x), which is low on the grid's y (-x world).
  EXPECT_FALSE(handleOf(shape, {1, false}).isHidden);
  EXPECT_TRUE(handleOf(shape, {1, true}).isHidden);
  EXPECT_FALSE(handleOf(shape, {2, true}).isHidden);
}

// From near by the middles of the sides lie beyond the picture: there no pointer could take hold of them.
TEST_P(BothProjections, aFaceWhoseMiddleLiesBeyondThePictureIsHeldWhereItIsSeen) {
  Camera near = camera;
  near.position *= GetParam() == Camera::Projection::perspective ? 0.28 : 1.0;
  near.heightMm *= 0.35;
  const ViewProjection from = viewProjection(near, picture);
  int beyond = 0, seen = 0;
  for (const CropHandle& handle : cropBoxShape({}, grid, from).handles) {
    const glm::dvec3 middle = faceCentre({}, grid, handle.face);
    EXPECT_TRUE(picture.adjusted(11.9, 11.9, -11.9, -11.9).contains(handle.centre));
    if (picture.contains(*pixelOf(from, middle)))
      continue; // as ever
    ++beyond;
    const double place = placeOf({}, handle.face);
    EXPECT_NEAR(placeUnder({}, grid, handle.face, from, handle.centre), place, 1e-9);
    // The face follows the pointer: what of it was held, if it is seen, lies where the pointer is.
    const QPointF to = handle.centre - 9.0 * handle.outward;
    const double movedMm =
        (placeUnder({}, grid, handle.face, from, to) - place) * boxSizeMm(grid)[handle.face.axis];
    const Ray ray = rayThrough(from, handle.centre);
    const glm::dvec3 axis = grid.direction[handle.face.axis];
    const double depth = glm::dot(middle - ray.origin, axis) / glm::dot(ray.direction, axis);
    const std::optional<QPointF> now = pixelOf(from, ray.origin + depth * ray.direction + movedMm * axis);
    EXPECT_LT(handle.face.isUpper ? movedMm : -movedMm, 0.0) << "inwards";
    const glm::dvec3 held = worldToIndex(grid, ray.origin + depth * ray.direction);
    const glm::dvec3 share = (held + 0.5) / glm::dvec3(grid.dims);
    const bool isOnFace = glm::all(glm::greaterThan(share, glm::dvec3(-1e-6))) &&
                          glm::all(glm::lessThan(share, glm::dvec3(1.0 + 1e-6)));
    EXPECT_TRUE(!isOnFace || (now && QLineF(*now, to).length() < 1e-6)) // rounding
        << handle.face.axis << handle.face.isUpper;
    seen += isOnFace;
  }
  EXPECT_GE(beyond, 2);
  EXPECT_GE(seen, GetParam() == Camera::Projection::orthographic ? 2 : 0);
}

INSTANTIATE_TEST_SUITE_P(CropBoxGeometry, BothProjections,
                         testing::Values(Camera::Projection::perspective, Camera::Projection::orthographic));

TEST(CropBoxGeometry, facesAcrossTheLineOfSightAreHeldAtTheirCorners) {
  for (const auto kind : {Camera::Projection::orthographic, Camera::Projection::perspective}) {
    Camera camera;
    camera.projection = kind;
    camera.position = {0.0, -200.0, 0.0};
    const Grid grid = turnedGrid();
    CropBox crop;
    crop.lower.x = 0.2;
    crop.upper.x = 0.8;
    const ViewProjection projection = viewProjection(camera, picture);
    const CropBoxShape shape = cropBoxShape(crop, grid, projection);
    ASSERT_EQ(shape.handles.size(), 6u);
    // The grid's x is the world's y, the line of sight: its faces are front and back.
    for (const CropFace face : {CropFace{0, false}, CropFace{0, true}}) {
      const CropHandle& handle = handleOf(shape, face);
      EXPECT_TRUE(handle.isAcross);
      EXPECT_EQ(handleAt(shape, handle.centre)->face, face) << "neither lies over the other";
      EXPECT_EQ(handle.isHidden, handle.outward.x() < 0.0) << "the one behind leads down to the left";
      EXPECT_EQ(handle.isHidden, handle.outward.y() > 0.0);
      EXPECT_NEAR(placeUnder(crop, grid, face, projection, handle.centre), placeOf(crop, face), 1e-12);
      // Ten millimetres, as they are seen beside the face, outwards.
      const QPointF perMm = pixelsPerMm(projection, faceCentre(crop, grid, face), projection.basis.right);
      const QPointF to = handle.centre + 10.0 * std::hypot(perMm.x(), perMm.y()) * handle.outward;
      const double grown = (face.isUpper ? 10.0 : -10.0) / boxSizeMm(grid).x;
      EXPECT_NEAR(placeUnder(crop, grid, face, projection, to), placeOf(crop, face) + grown, 1e-9);
    }
    EXPECT_FALSE(handleOf(shape, {2, true}).isAcross);
  }
}

TEST(CropBoxGeometry, theHandleOfABoxBeyondThePictureStandsInThePicture) {
  Camera camera;
  camera.position = {0.0, -90.0, 0.0};
  const CropBoxShape shape = cropBoxShape({}, turnedGrid(), viewProjection(camera, picture));
  for (const CropHandle& handle : shape.handles)
    if (handle.isAcross) {
      EXPECT_TRUE(picture.contains(handle.centre)) << handle.face.axis << handle.face.isUpper;
    }
}

TEST(CropBoxGeometry, aHandleIsHeldWithinTwelvePixelsAndTheVisibleOneFirst) {
  CropBoxShape shape;
  shape.handles = {{{0, false}, {100.0, 100.0}, {1.0, 0.0}, true},
                   {{0, true}, {110.0, 100.0}, {1.0, 0.0}, false}};
  EXPECT_EQ(handleAt(shape, {101.0, 100.0})->face, (CropFace{0, true})); // the other is nearer, but behind
  EXPECT_EQ(handleAt(shape, {97.0, 100.0})->face, (CropFace{0, false})); // 13 pixels from the one before
  EXPECT_FALSE(handleAt(shape, {110.0, 112.5}));
  EXPECT_TRUE(handleAt(shape, {110.0, 111.5}));
}

TEST(CropBoxGeometry, whatIsBehindTheEyeIsLeftOut) {
  Camera camera;
  camera.position = {0.0, 0.0, 0.0}; // in the middle of the box
  camera.target = {0.0, 10.0, 0.0};
  const Grid grid = turnedGrid();
  const CropBoxShape shape = cropBoxShape({}, grid, viewProjection(camera, picture));
  // The four edges of the face behind are gone, the four that lead there are cut off.
  EXPECT_EQ(shape.edges.size(), 8u);
  for (const CropEdge& edge : shape.edges)
    EXPECT_TRUE(std::isfinite(edge.line.x1()) && std::isfinite(edge.line.y2()));
  // The face ahead is straight before the eye; the four others have their centres beside it, at depth 0.
  EXPECT_EQ(shape.handles.size(), 1u);
}

TEST(CropBoxGeometry, beyondTheVanishingPointAFaceGoesToTheEnd) {
  Camera camera;
  camera.position = {60.0, -200.0, 0.0}; // looks along +y past the box: the axis vanishes in the centre
  camera.target = {60.0, 0.0, 0.0};
  const Grid grid = turnedGrid();
  const ViewProjection projection = viewProjection(camera, picture);
  const CropFace far{0, true};
  const QPointF vanishing = picture.center();
  const QPointF handle = *pixelOf(projection, faceCentre({}, grid, far));
  const QPointF beyond = vanishing + 0.5 * (vanishing - handle);
  EXPECT_EQ(withFaceAt({}, grid, far, placeUnder({}, grid, far, projection, beyond)).upper.x, 1.0);
}

TEST(CropBoxGeometry, cursorsFollowTheWayAFaceMoves) {
  const auto cursor = [](double x, double y) {
    const double length = std::hypot(x, y);
    return cursorFor({{0, false}, {}, {x / length, y / length}});
  };
  EXPECT_EQ(cursor(1, 0), Qt::SizeHorCursor);
  EXPECT_EQ(cursor(-1, 0.1), Qt::SizeHorCursor);
  EXPECT_EQ(cursor(0, -1), Qt::SizeVerCursor);
  EXPECT_EQ(cursor(0, 1), Qt::SizeVerCursor);
  EXPECT_EQ(cursor(1, -1), Qt::SizeBDiagCursor); // up to the right: /
  EXPECT_EQ(cursor(-1, 1), Qt::SizeBDiagCursor);
  EXPECT_EQ(cursor(1, 1), Qt::SizeFDiagCursor);
}

} // namespace
} // namespace limn
