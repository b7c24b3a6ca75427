// SPDX-License-Identifier: GPL-3.0-or-later
// The proxy geometry in double precision: what each slab's polygon must cover, and in what order slabs come.
#include "slices/ProxySlabs.h"

#include "scene/steps/RayFrame.h"
#include "support/AnalyticScenes.h"

#include <gtest/gtest.h>

#include <random>

namespace limn {
namespace {

constexpr glm::ivec2 slabsSize{37, 29};

Scene boxScene(const glm::dvec3& spacing = {1.0, 1.5, 0.7}) {
  Grid grid;
  grid.dims = {5, 4, 6};
  grid.spacingMm = spacing;
  grid.originMm = {3.0, -2.0, 7.0};
  Scene scene;
  scene.volume = std::make_shared<const Volume>(grid, std::vector<float>(120, 1.0f), Rescale{}, std::nullopt,
                                                VolumeInfo{});
  scene.camera = defaultCamera(grid);
  scene.quality.stepVoxels = 0.8;
  return scene;
}

double signedArea(const ConvexPolygon& polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2& a = polygon[i];
    const glm::dvec2& b = polygon[(i + 1) % polygon.size()];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return area;
}

bool isStrictlyConvex(const ConvexPolygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[(i + 1) % polygon.size()] - polygon[i];
    const glm::dvec2 b = polygon[(i + 2) % polygon.size()] - polygon[(i + 1) % polygon.size()];
    if (!(a.x * b.y - a.y * b.x > 0.0))
      return false;
  }
  return polygon.size() >= 3;
}

bool covers(const ConvexPolygon& polygon, const glm::dvec2& point) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    const glm::dvec2 toPoint = point - polygon[i];
    if (!(edge.x * toPoint.y - edge.y * toPoint.x > 0.0))
      return false;
  }
  return polygon.size() >= 3;
}

// The length of a pixel's ray in the box, and of its pieces in the slabs whose polygons cover the pixel.
struct Lengths {
  double inBox = 0.0;
  double inSlabs = 0.0;
};

Lengths lengthsAt(const Scene& scene, const std::vector<ProxySlab>& slabs, int x, int y) {
  const Grid& grid = scene.volume->grid();
  const RayFrame frame = rayFrame(scene.camera, grid, slabsSize);
  const FramedRay ray = framedRay(frame, x, y, slabsSize);
  const RaySpan span = spanInBox(ray, croppedBox(grid, scene.crop));
  if (span.isEmpty())
    return {};
  const glm::dvec2 centre(x + 0.5 - slabsSize.x / 2.0, slabsSize.y / 2.0 - (y + 0.5));
  const double mmPerDepth =
      std::sqrt(1.0 + glm::dot(centre, centre) * frame.tangentPerPixel * frame.tangentPerPixel);
  Lengths lengths{span.end - span.begin, 0.0};
  for (const ProxySlab& slab : slabs)
    if (covers(slab.polygon, centre))
      lengths.inSlabs += std::max(0.0, std::min(span.end, slab.farMm * mmPerDepth) -
                                           std::max(span.begin, slab.nearMm * mmPerDepth));
  return lengths;
}

int expectEveryRayCovered(const Scene& scene) {
  const std::vector<ProxySlab> slabs = proxySlabs(scene, slabsSize);
  int hits = 0;
  for (int y = 0; y < slabsSize.y; ++y)
    for (int x = 0; x < slabsSize.x; ++x) {
      const Lengths lengths = lengthsAt(scene, slabs, x, y);
      EXPECT_NEAR(lengths.inSlabs, lengths.inBox, 1e-9) << x << ", " << y;
      hits += lengths.inBox > 0.0;
    }
  for (const ProxySlab& slab : slabs) {
    EXPECT_TRUE(isStrictlyConvex(slab.polygon));
    EXPECT_GT(signedArea(slab.polygon), 0.0);
    for (const glm::dvec2& corner : slab.polygon)
      EXPECT_EQ(glm::round(corner * gridPerPixel), corner * gridPerPixel) << "off the grid";
  }
  return hits;
}

TEST(ProxySlabs, theSlabsOfARandomCameraCoverEveryRayOfItsPicture) {
  std::mt19937 random(5); // fixed seed
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto anywhere = [&] { return glm::dvec3(unit(random), unit(random), unit(random)); };
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Scene scene = boxScene();
    const glm::dvec3 centre = boxCentreMm(scene.volume->grid());
    // Two in three stand outside, the others in the box or close to it.
    scene.camera.position = centre + (i % 3 == 0 ? 2.0 : 12.0) * anywhere();
    scene.camera.target = centre + 2.0 * anywhere();
    scene.camera.up = anywhere();
    if (i % 2 == 0)
      scene.camera.projection = Camera::Projection::orthographic;
    scene.camera.heightMm = 12.0;
    scene.camera.fovYDeg = i % 5 == 0 ? 110.0 : 30.0;
    if (i % 4 == 0)
      scene.crop = {{0.1, 0.0, 0.3}, {0.9, 0.55, 1.0}};
    hits += expectEveryRayCovered(scene);
  }
  EXPECT_GT(hits, 50000);
}

TEST(ProxySlabs, camerasAlongTheAxesAndInFacesAreCoveredToo) {
  for (const StandardView view : {StandardView::anterior, StandardView::posterior, StandardView::left,
                                  StandardView::right, StandardView::superior, StandardView::inferior})
    for (const auto projection : {Camera::Projection::perspective, Camera::Projection::orthographic}) {
      Scene scene = boxScene(glm::dvec3(1.0));
      const Grid& grid = scene.volume->grid();
      scene.camera = standardView(scene.camera, grid, view);
      scene.camera.projection = projection;
      scene.camera.heightMm = 29.0;                // pixel centres on voxel faces
      EXPECT_GE(expectEveryRayCovered(scene), 20); // the smallest side has 4 x 5 voxels of a pixel
      scene.camera.position = boxCentreMm(grid) + glm::dvec3(2.5, 2.0, 3.0); // a corner
      EXPECT_GT(expectEveryRayCovered(scene), 0);
      scene.camera.position = boxCentreMm(grid);
      EXPECT_GT(expectEveryRayCovered(scene), 20);
    }
}

TEST(ProxySlabs, slabsAreSortedAdjacentAndNoThickerThanAStep) {
  Scene scene = boxScene();
  scene.camera = orbited(scene.camera, 0.7, 0.3);
  const std::vector<ProxySlab> slabs = proxySlabs(scene, slabsSize);
  ASSERT_GT(slabs.size(), 8u);
  for (std::size_t i = 1; i < slabs.size(); ++i)
    EXPECT_EQ(slabs[i].nearMm, slabs[i - 1].farMm);
  for (std::size_t i = 1; i + 1 < slabs.size(); ++i) {
    EXPECT_GT(slabs[i].farMm, slabs[i].nearMm);
    EXPECT_LE(slabs[i].farMm - slabs[i].nearMm, stepMm(scene) * (1.0 + 1e-5));
  }
  // The box's own faces end the outermost slabs.
  EXPECT_LT(slabs.front().nearMm, -1e20);
  EXPECT_GT(slabs.back().farMm, 1e20);
  EXPECT_EQ(slabs.size(), static_cast<std::size_t>(std::ceil(slabsWanted(scene, slabsSize))));
}

TEST(ProxySlabs, aBoxOfAWholeNumberOfStepsSeenAlongAnAxisHasThatManySlabs) {
  Scene scene = boxScene(glm::dvec3(1.0));
  scene.quality.stepVoxels = 0.5;
  // Along y the box is 4 voxels deep.
  EXPECT_EQ(proxySlabs(scene, slabsSize).size(), 8u);
}

TEST(ProxySlabs, polygonsHugTheBoxInsteadOfFillingThePicture) {
  const Scene scene = boxScene();
  for (const ProxySlab& slab : proxySlabs(scene, slabsSize))
    EXPECT_LT(signedArea(slab.polygon), 0.5 * slabsSize.x * slabsSize.y);
}

TEST(ProxySlabs, thereAreNoneBehindTheEyeOrBesideThePicture) {
  Scene scene = boxScene();
  scene.camera.target = scene.camera.position + (scene.camera.position - scene.camera.target);
  EXPECT_TRUE(proxySlabs(scene, slabsSize).empty()) << "behind";
  scene = boxScene();
  scene.camera.position.x += 1000.0;
  scene.camera.target.x += 1000.0;
  EXPECT_TRUE(proxySlabs(scene, slabsSize).empty()) << "beside";
}

TEST(ProxySlabs, aTinyStepIsLimitedToTheMostSamplesOfTheDefinition) {
  Scene scene = boxScene();
  scene.quality.stepVoxels = 1e-4;
  EXPECT_LE(proxySlabs(scene, slabsSize).size(), static_cast<std::size_t>(mostSamples));
  scene.quality.stepVoxels = 1e-5;
  EXPECT_GT(slabsWanted(scene, slabsSize), mostSamples);
  EXPECT_EQ(proxySlabs(scene, slabsSize).size(), static_cast<std::size_t>(mostSamples));
}

TEST(ConvexPolygon, aHullHasNoCornerOnItsEdges) {
  const ConvexPolygon hull = convexHull({{0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 2}, {2, 0}});
  EXPECT_EQ(hull, (ConvexPolygon{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
  EXPECT_TRUE(convexHull({{0, 0}, {1, 1}, {2, 2}}).empty());
  EXPECT_TRUE(convexHull({{0, 0}, {1, 1}}).empty());
}

TEST(ConvexPolygon, clippingKeepsThePartInsideTheRectangle) {
  // A square of side 4 turned by 45 degrees around (0, 0) and the unit square: a triangle of area 1/2 is cut
  // off at none, the whole unit square remains where it lies inside.
  const ConvexPolygon diamond{{-2, 0}, {0, -2}, {2, 0}, {0, 2}};
  EXPECT_DOUBLE_EQ(signedArea(clipped(diamond, {0.0, 0.0}, {1.0, 1.0})), 1.0);
  // The quadrant x, y ≥ 0 of the diamond is a triangle of area 2.
  EXPECT_DOUBLE_EQ(signedArea(clipped(diamond, {0.0, 0.0}, {5.0, 5.0})), 2.0);
  EXPECT_TRUE(clipped(diamond, {3.0, 3.0}, {4.0, 4.0}).empty());
}

} // namespace
} // namespace limn
