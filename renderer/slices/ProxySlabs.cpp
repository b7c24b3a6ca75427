// SPDX-License-Identifier: GPL-3.0-or-later
#include "slices/ProxySlabs.h"

#include "scene/steps/RayFrame.h"

#include <algorithm>
#include <array>

namespace limn {
namespace {

// Positive where a, b, c turn to the left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Adds points from one end to the other and drops those that the polygon does not turn left at.
template <class Iterator>
void addChain(Iterator begin, Iterator end, ConvexPolygon& hull) {
  const std::size_t start = hull.size();
  for (Iterator point = begin; point != end; ++point) {
    while (hull.size() >= start + 2 && !(turn(hull[hull.size() - 2], hull.back(), *point) > 0.0))
      hull.pop_back();
    hull.push_back(*point);
  }
  hull.pop_back(); // the other chain begins there
}

// Keeps what lies on the side of the half plane where `signedDistance` is not negative.
template <class Distance>
ConvexPolygon clippedBy(const ConvexPolygon& polygon, const Distance& signedDistance) {
  ConvexPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2& here = polygon[i];
    const glm::dvec2& next = polygon[(i + 1) % polygon.size()];
    const double a = signedDistance(here);
    const double b = signedDistance(next);
    if (a >= 0.0)
      kept.push_back(here);
    if ((a >= 0.0) != (b >= 0.0))
      kept.push_back(here + (next - here) * (a / (a - b)));
  }
  return kept;
}

constexpr double beyondBoxMm = 1e30;

struct Depths {
  double nearest = 0.0;
  double farthest = 0.0;
};

// The box as the camera sees it.
struct View {
  RayFrame frame;
  glm::dvec3 spacingMm;
  glm::dvec2 halfSize; // pixels
  std::array<glm::dvec3, 8> corners{};
  std::array<double, 8> depths{};

  View(const Scene& scene, const glm::ivec2& size)
      : frame(rayFrame(scene.camera, scene.volume->grid(), size)), spacingMm(scene.volume->grid().spacingMm),
        halfSize(glm::dvec2(size) / 2.0) {
    const IndexBox box = croppedBox(scene.volume->grid(), scene.crop);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      corners[i] = {(i & 1) != 0 ? box.upper.x : box.lower.x, (i & 2) != 0 ? box.upper.y : box.lower.y,
                    (i & 4) != 0 ? box.upper.z : box.lower.z};
      depths[i] = glm::dot((corners[i] - frame.anchor) * spacingMm, frame.direction * spacingMm);
    }
  }

  Depths depthsOfBox() const {
    const auto [nearest, farthest] = std::minmax_element(depths.begin(), depths.end());
    return {std::max(*nearest, -frame.anchorDistanceMm), *farthest};
  }

  glm::dvec2 inPicture(const glm::dvec3& point, double depth) const {
    const glm::dvec3 offset = (point - frame.anchor) * spacingMm;
    const glm::dvec3 x = (frame.anchorX + depth * frame.directionX) * spacingMm;
    const glm::dvec3 y = (frame.anchorY + depth * frame.directionY) * spacingMm;
    return {glm::dot(offset, x) / glm::dot(x, x), glm::dot(offset, y) / glm::dot(y, y)};
  }
};

// The corners of the part of the box between two depths, as the picture shows them.
std::vector<glm::dvec2> cornersBetween(const View& view, double nearMm, double farMm) {
  std::vector<glm::dvec2> seen;
  for (std::size_t i = 0; i < 8; ++i)
    if (view.depths[i] >= nearMm && view.depths[i] <= farMm)
      seen.push_back(view.inPicture(view.corners[i], view.depths[i]));
  for (std::size_t i = 0; i < 8; ++i)
    for (const std::size_t bit : {1u, 2u, 4u}) {
      if ((i & bit) != 0)
        continue;
      // An edge of the box crosses a plane where its ends lie on either side.
      const double from = view.depths[i];
      const double to = view.depths[i | bit];
      for (const double plane : {nearMm, farMm})
        if ((from < plane) != (to < plane)) {
          const double share = (plane - from) / (to - from);
          seen.push_back(view.inPicture(glm::mix(view.corners[i], view.corners[i | bit], share), plane));
        }
    }
  return seen;
}

// The polygon on the grid that covers a polygon of the picture with a margin of a line of the grid, for what
// rounding loses here and in the rasteriser.
ConvexPolygon onGrid(const ConvexPolygon& polygon) {
  std::vector<glm::dvec2> around;
  for (const glm::dvec2& corner : polygon)
    for (const glm::dvec2& shift : {glm::dvec2(-1.5), {1.5, -1.5}, {-1.5, 1.5}, glm::dvec2(1.5)})
      around.push_back(glm::round(gridPerPixel * corner + shift));
  ConvexPolygon hull = convexHull(std::move(around));
  for (glm::dvec2& corner : hull)
    corner /= gridPerPixel;
  return hull;
}

ConvexPolygon coverOf(const View& view, double nearMm, double farMm) {
  const glm::dvec2 beyond = view.halfSize + 1.0;
  // At the eye the picture has no bounds.
  const double fromEye = nearMm + view.frame.anchorDistanceMm;
  if (view.frame.tangentPerPixel > 0.0 && fromEye < 1e-6 * (farMm - nearMm))
    return onGrid({-beyond, {beyond.x, -beyond.y}, beyond, {-beyond.x, beyond.y}});
  return onGrid(clipped(convexHull(cornersBetween(view, nearMm, farMm)), -beyond, beyond));
}

} // namespace

ConvexPolygon convexHull(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(),
            [](const glm::dvec2& a, const glm::dvec2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
    return {};
  ConvexPolygon hull;
  addChain(points.begin(), points.end(), hull);
  addChain(points.rbegin(), points.rend(), hull);
  return hull.size() < 3 ? ConvexPolygon{} : hull;
}

ConvexPolygon clipped(const ConvexPolygon& polygon, const glm::dvec2& lower, const glm::dvec2& upper) {
  ConvexPolygon part = polygon;
  for (int axis = 0; axis < 2; ++axis) {
    part = clippedBy(part, [&](const glm::dvec2& p) { return p[axis] - lower[axis]; });
    part = clippedBy(part, [&](const glm::dvec2& p) { return upper[axis] - p[axis]; });
  }
  return part.size() < 3 ? ConvexPolygon{} : part;
}

double slabsWanted(const Scene& scene, const glm::ivec2& size) {
  const Depths box = View(scene, size).depthsOfBox();
  return std::max(0.0, (box.farthest - box.nearest) / stepMm(scene));
}

std::vector<ProxySlab> proxySlabs(const Scene& scene, const glm::ivec2& size) {
  const View view(scene, size);
  const Depths box = view.depthsOfBox();
  std::vector<ProxySlab> slabs;
  if (!(box.farthest > box.nearest))
    return slabs;
  const int count = sampleCount(box.farthest - box.nearest, stepMm(scene));
  const double thickness = (box.farthest - box.nearest) / count;
  const auto plane = [&](int i) { return i == count ? box.farthest : box.nearest + i * thickness; };
  for (int i = 0; i < count; ++i) {
    ProxySlab slab{i == 0 ? -beyondBoxMm : plane(i), i + 1 == count ? beyondBoxMm : plane(i + 1),
                   coverOf(view, plane(i), plane(i + 1))};
    if (!slab.polygon.empty())
      slabs.push_back(std::move(slab));
  }
  return slabs;
}

} // namespace limn
