// SPDX-License-Identifier: GPL-3.0-or-later
#include "slices/ProxySlabs.h"

#include <algorithm>

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

} // namespace limn
