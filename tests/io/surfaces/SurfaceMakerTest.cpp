// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceMaker.h"

#include "SampledFields.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

// Isosurfaces as meshes: where they lie, how they hang together, where they end.

namespace limn {
namespace {

using test::ball;
using test::centredGrid;
using test::sampledScene;

constexpr double radiusMm = 20.0;
constexpr double spacingMm = 0.5;
const double ballMm3 = 4.0 / 3.0 * std::numbers::pi * std::pow(radiusMm, 3);
// Between voxel centres the trilinear field lies off the ball's by at most an eighth of the squared spacing
// times the sum of its second derivatives, which is 2 / radius.
constexpr double ofTrilinearMm = spacingMm * spacingMm / 8.0 * 2.0 / radiusMm;

SurfaceOrder at(double isovalue) {
  SurfaceOrder order;
  order.isovalue = isovalue;
  return order;
}

Scene ballScene(const glm::dvec3& centreMm = glm::dvec3(0.0)) {
  return sampledScene(centredGrid(96, spacingMm, centreMm), ball(centreMm, radiusMm));
}

// The largest distance of points, and of the middles of triangles, from the ball.
double farthestFromBall(const SurfaceMesh& mesh, const glm::dvec3& centreMm = glm::dvec3(0.0)) {
  double most = 0.0;
  const auto look = [&](const glm::dvec3& point) {
    most = std::max(most, std::abs(glm::length(point - centreMm) - radiusMm));
  };
  for (const glm::vec3& point : mesh.points)
    look(point);
  for (const glm::uvec3& t : mesh.triangles)
    look(glm::dvec3(mesh.points[t.x] + mesh.points[t.y] + mesh.points[t.z]) / 3.0);
  return most;
}

// How many triangles turn their front away from the ball.
std::size_t turnedOutwards(const SurfaceMesh& mesh, const glm::dvec3& centreMm) {
  return static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const glm::uvec3& t) {
        return glm::dot(areaVector(mesh, t), glm::dvec3(mesh.points[t.x]) - centreMm) > 0.0;
      }));
}

TEST(Surface, ofABallLiesWithinTheMeasuredDistance) {
  const MadeSurface made = makeSurface(ballScene(), at(0.0));
  EXPECT_GT(made.mesh.triangles.size(), 10000u);
  EXPECT_LE(farthestFromBall(made.mesh), made.error.largest() + ofTrilinearMm);
  EXPECT_GT(made.error.largest(), 0.0);
  // A chord of a cell's diagonal, √3 spacings, is farthest from the ball at its middle: length² / (8 radius).
  EXPECT_LT(made.error.largest(), 3.0 * spacingMm * spacingMm / (8.0 * radiusMm) + ofTrilinearMm);
  EXPECT_TRUE(made.edges.isWatertight());
  EXPECT_EQ(made.parts, 1u);
  EXPECT_NEAR(made.enclosedMm3, ballMm3, 1e-3 * ballMm3);
  EXPECT_EQ(turnedOutwards(made.mesh, glm::dvec3(0.0)), made.mesh.triangles.size());
}

TEST(Surface, hasTheNormalsOfTheField) {
  const MadeSurface made = makeSurface(ballScene(), at(0.0));
  ASSERT_EQ(made.mesh.normals.size(), made.mesh.points.size());
  for (std::size_t i = 0; i < made.mesh.points.size(); ++i) {
    // Out of the ball, to within the half degree that central differences of this spacing allow.
    const glm::dvec3 outwards = glm::normalize(glm::dvec3(made.mesh.points[i]));
    ASSERT_GT(glm::dot(outwards, glm::dvec3(made.mesh.normals[i])), std::cos(0.5 * std::numbers::pi / 180.0));
  }
}

TEST(Surface, ofObliqueAndMirroredGridsLiesInThePatientAndFacesOutwards) {
  const glm::dvec3 centre(30.0, -70.0, 110.0);
  for (const double mirror : {1.0, -1.0}) {
    Grid grid;
    grid.dims = {120, 90, 60};
    grid.spacingMm = {0.4, 0.55, 0.8};
    // Turned about two axes; the third column closes a right-handed or a left-handed system.
    grid.direction[0] = glm::normalize(glm::dvec3(0.8, 0.5, 0.2));
    grid.direction[1] = glm::normalize(glm::cross(glm::dvec3(0.1, -0.3, 1.0), grid.direction[0]));
    grid.direction[2] = mirror * glm::cross(grid.direction[0], grid.direction[1]);
    grid.originMm = centre - grid.direction * (grid.spacingMm * 0.5 * glm::dvec3(grid.dims - 1));
    const MadeSurface made = makeSurface(sampledScene(grid, ball(centre, radiusMm)), at(0.0));
    EXPECT_TRUE(made.edges.isWatertight());
    EXPECT_NEAR(made.enclosedMm3, ballMm3, 2e-3 * ballMm3) << "coarser than half a millimetre";
    EXPECT_EQ(turnedOutwards(made.mesh, centre), made.mesh.triangles.size()) << mirror;
    EXPECT_LT(farthestFromBall(made.mesh, centre), 0.05);
  }
}

TEST(Surface, isClosedFlatAtTheCropOrLeftOpenThere) {
  Scene scene = ballScene();
  scene.crop.lower.x = 0.5 + 3.3 / (96.0 * spacingMm); // 3.3 mm right of the middle, between voxel centres
  const MadeSurface closed = makeSurface(scene, at(0.0));
  EXPECT_TRUE(closed.edges.isWatertight());
  // A cap of the ball, π h² (3r - h) / 3.
  const double height = radiusMm - 3.3,
               cap = std::numbers::pi * height * height * (3.0 * radiusMm - height) / 3.0;
  EXPECT_NEAR(closed.enclosedMm3, cap, 1e-3 * cap);
  double least = 1e9;
  for (const glm::vec3& point : closed.mesh.points)
    least = std::min(least, static_cast<double>(point.x));
  EXPECT_NEAR(least, 3.3, 1e-5);

  SurfaceOrder order = at(0.0);
  order.isClosed = false;
  const MadeSurface open = makeSurface(scene, order);
  EXPECT_FALSE(open.edges.isWatertight());
  EXPECT_GT(open.edges.usedOnce, 100u);
  EXPECT_EQ(open.edges.usedOtherwise, 0u);
  EXPECT_LE(farthestFromBall(open.mesh), open.error.largest() + ofTrilinearMm) << "nothing lies in the plane";
  EXPECT_LT(open.mesh.triangles.size(), closed.mesh.triangles.size());
}

TEST(Surface, isMeasuredAtSpecksInThePlaneOfTheCropToo) {
  // Of one bright voxel the crop leaves what rises towards it: in the plane, 0.7 voxels before its centre,
  // the field reaches 30 at a single place, and no other direction than those of the grid leads there.
  Grid grid;
  grid.dims = {9, 9, 9};
  Scene scene =
      sampledScene(grid, [](const glm::dvec3& mm) { return mm == glm::dvec3(5.0, 4.0, 4.0) ? 100.0 : 0.0; });
  scene.crop.upper.x = (4.3 + 0.5) / 9.0;
  const MadeSurface made = makeSurface(scene, at(29.999));
  EXPECT_TRUE(made.edges.isWatertight());
  EXPECT_LT(made.error.largest(), 0.002) << "points stay 0.001 voxels from a corner";
}

TEST(Surface, endsWhereTheVolumeEndsHalfAVoxelBeyondTheLastCentre) {
  // The same value everywhere but in one voxel: the surface at a value between is the box but for a corner.
  Grid grid;
  grid.dims = {4, 5, 1};
  grid.spacingMm = {2.0, 1.0, 3.0};
  const Scene scene =
      sampledScene(grid, [](const glm::dvec3& mm) { return mm.x + mm.y > 0.0 ? 100.0 : 0.0; });
  const MadeSurface made = makeSurface(scene, at(50.0));
  EXPECT_TRUE(made.edges.isWatertight());
  // Of the box of 8 × 5 × 3 mm the voxel of 2 × 1 × 3 mm at the corner is missing, but not its rounded
  // corner.
  EXPECT_LT(made.enclosedMm3, 120.0 - 4.0);
  EXPECT_GT(made.enclosedMm3, 120.0 - 6.0);
}

TEST(Surface, isBoundedByTheKeptRegion) {
  Scene scene = ballScene();
  const glm::ivec3 dims = scene.volume->grid().dims;
  std::vector<std::uint8_t> places;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        places.push_back(i < dims.x / 2 ? 1 : 0);
  scene.keep = bodyRegion(dims, std::move(places));
  const MadeSurface closed = makeSurface(scene, at(0.0));
  EXPECT_TRUE(closed.edges.isWatertight());
  // The weight is ½ in the middle between the 48th and the 49th voxel: the middle of the ball.
  EXPECT_NEAR(closed.enclosedMm3, ballMm3 / 2.0, 1e-3 * ballMm3);
  SurfaceOrder order = at(0.0);
  order.isClosed = false;
  const MadeSurface open = makeSurface(scene, order);
  EXPECT_GT(open.edges.usedOnce, 100u);
  EXPECT_LE(farthestFromBall(open.mesh), open.error.largest() + ofTrilinearMm);
}

TEST(Surface, isWatertightThroughValuesThatVoxelsHave) {
  // Noise of few values, many of them the isovalue itself: every way that a cell can be crossed occurs.
  std::mt19937 random(7);
  Grid grid;
  grid.dims = {40, 37, 60};
  std::vector<std::uint8_t> stored(40 * 37 * 60);
  for (std::uint8_t& value : stored)
    value = static_cast<std::uint8_t>(random() % 5);
  Scene scene;
  scene.volume = std::make_shared<Volume>(grid, std::move(stored), Rescale{}, std::nullopt, VolumeInfo{});
  for (const double isovalue : {2.0, 2.5, 4.0}) {
    const MadeSurface made = makeSurface(scene, at(isovalue));
    EXPECT_GT(made.mesh.triangles.size(), 50000u);
    EXPECT_EQ(made.edges.usedOnce, 0u) << isovalue;
    EXPECT_EQ(made.edges.usedOtherwise, 0u) << isovalue;
    // No point of the mesh is farther from the field's own surface than a cell is wide.
    EXPECT_LT(made.error.largest(), std::sqrt(3.0));
  }
}

TEST(Surface, losesSmallPartsAndFillsSmallHollowsWhereAsked) {
  // A ball of radius 8 with a hollow of radius 3, and a ball of radius 2 beside it.
  const auto big = ball(glm::dvec3(-6.0, 0.0, 0.0), 8.0), hollow = ball(glm::dvec3(-6.0, 0.0, 0.0), 3.0);
  const auto speck = ball(glm::dvec3(9.0, 0.0, 0.0), 2.0);
  const Scene scene = sampledScene(centredGrid(64, 0.5), [&](const glm::dvec3& mm) {
    return std::max(std::min(big(mm), -hollow(mm)), speck(mm));
  });
  const auto volumeOf = [](double r) { return 4.0 / 3.0 * std::numbers::pi * r * r * r; };
  SurfaceOrder order = at(0.0);
  const MadeSurface all = makeSurface(scene, order);
  EXPECT_EQ(all.parts, 2u);
  EXPECT_NEAR(all.enclosedMm3, volumeOf(8.0) - volumeOf(3.0) + volumeOf(2.0), 5.0);

  order.smallestPartMm3 = 50.0; // more than the speck's 33.5, less than the hollow's 113
  const MadeSurface clean = makeSurface(scene, order);
  EXPECT_EQ(clean.parts, 1u);
  EXPECT_EQ(clean.dropped.parts, 1u);
  EXPECT_EQ(clean.dropped.hollows, 0u);
  // Field and chords lie up to an eighth of the squared spacing over the radius inside each: 0.03 mm on 50
  // mm².
  EXPECT_NEAR(clean.dropped.enclosedMm3, volumeOf(2.0), 1.5);

  order.smallestPartMm3 = 150.0;
  const MadeSurface filled = makeSurface(scene, order);
  EXPECT_EQ(filled.dropped.hollows, 1u);
  EXPECT_NEAR(filled.enclosedMm3, volumeOf(8.0), 5.0);
}

TEST(Surface, losesTrianglesAndKeepsTheStatedDistance) {
  for (const double toleranceMm : {0.02, 0.1}) {
    SurfaceOrder order = at(0.0);
    order.toleranceMm = toleranceMm;
    const MadeSurface made = makeSurface(ballScene(), order);
    EXPECT_LT(made.mesh.triangles.size(), made.trianglesBefore / 4);
    EXPECT_LE(made.error.largest(), toleranceMm);
    EXPECT_LE(farthestFromBall(made.mesh), toleranceMm + ofTrilinearMm);
    EXPECT_TRUE(made.edges.isWatertight());
    EXPECT_NEAR(made.enclosedMm3, ballMm3, 3.0 * toleranceMm / radiusMm * ballMm3);
    EXPECT_EQ(turnedOutwards(made.mesh, glm::dvec3(0.0)), made.mesh.triangles.size());
  }
}

TEST(Surface, staysWatertightAndKeepsItsRimsAsTrianglesGo) {
  Scene scene = ballScene();
  scene.crop.lower.x = 0.6;
  SurfaceOrder order = at(0.0);
  order.toleranceMm = 0.1;
  EXPECT_TRUE(makeSurface(scene, order).edges.isWatertight());
  order.isClosed = false;
  const std::uint64_t rims = makeSurface(scene, order).edges.usedOnce;
  order.toleranceMm = 0.0;
  EXPECT_EQ(rims, makeSurface(scene, order).edges.usedOnce);
}

TEST(Surface, followsTheFieldMoreCloselyWithFinerCells) {
  // A saddle between voxels is what one cell a voxel cannot follow.
  const Scene scene = sampledScene(centredGrid(24, 1.0), [](const glm::dvec3& mm) {
    return std::sin(1.3 * mm.x) * std::sin(1.1 * mm.y) + std::sin(1.2 * mm.z);
  });
  const MadeSurface coarse = makeSurface(scene, at(0.1));
  SurfaceOrder order = at(0.1);
  order.cells = 3;
  const MadeSurface fine = makeSurface(scene, order);
  EXPECT_TRUE(fine.edges.isWatertight());
  EXPECT_LT(fine.error.largest(), coarse.error.largest() / 2.0);
  EXPECT_LT(fine.error.ofMesh.mean, coarse.error.ofMesh.mean / 4.0); // nine times fewer where all is smooth
}

TEST(Surface, tellsHowLargeItWillBe) {
  const Scene scene = ballScene();
  const SurfaceEstimate estimate = estimatedSurface(scene, at(0.0));
  EXPECT_NEAR(static_cast<double>(estimate.triangles),
              static_cast<double>(makeSurface(scene, at(0.0)).mesh.triangles.size()), 10.0);
}

TEST(Surface, endsWhenItIsCancelled) {
  const Scene scene = ballScene();
  SurfaceOrder order = at(0.0);
  order.toleranceMm = 0.1;
  Progress progress;
  double done = 0.0;
  progress.report = [&done](double fraction, const Message&) { done = fraction; };
  // However far it is. How often it asks would depend on how many pieces of work the asking thread gets.
  for (const double far : {0.0, 0.1, 0.25, 0.4, 0.6, 0.82, 0.9, 0.97}) {
    done = 0.0;
    progress.isCancelled = [&done, far] { return done >= far; };
    EXPECT_THROW(makeSurface(scene, order, progress), Cancelled) << far;
  }
}

std::string refusalOf(const Scene& scene, const SurfaceOrder& order) {
  try {
    makeSurface(scene, order);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    return error.what();
  }
  return "none";
}

TEST(Surface, isRefusedInOneSentenceWhereThereIsNone) {
  Scene scene = sampledScene(centredGrid(32, 0.5), ball(glm::dvec3(0.0), 6.0));
  EXPECT_TRUE(refusalOf(scene, at(6.5))
                  .starts_with("There is no surface at 6.5, because the volume has values from"));
  EXPECT_TRUE(refusalOf(scene, at(-400.0)).starts_with("There is no surface at -400, because"));
  scene.crop.upper = glm::dvec3(0.1); // a corner outside the ball
  EXPECT_EQ(refusalOf(scene, at(1.0)),
            "There is no surface at 1: nothing within the crop and what is kept reaches "
            "it; choose a lower value or a larger crop.");
}

TEST(Surface, isRefusedBeforeItBeginsWhereMemoryWouldNotSuffice) {
  SurfaceOrder order = at(0.0);
  order.memoryBytes = 1e6;
  const std::string sentence = refusalOf(ballScene(), order);
  EXPECT_TRUE(sentence.starts_with("The surface would have about 0.0")) << sentence;
  EXPECT_NE(sentence.find("crop the volume, choose another value or open a coarser volume."),
            std::string::npos);
}

} // namespace
} // namespace limn
