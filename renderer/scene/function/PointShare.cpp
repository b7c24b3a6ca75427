// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/PointShare.h"

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

// What is left of the opacity of everything else.
constexpr double faintest = 0.08;

// What a point governs is at least so opaque, over the unit distance, where the point is not transparent.
constexpr double wellLit = 0.25;

// Opacity times share is no straight line between two points, but nearly so over an eighth of the way.
constexpr int partsBetweenPoints = 8;

// Rec. 709 weights, on display values: the grey that is about as bright.
glm::dvec3 greyOfColor(const glm::dvec3& color) {
  return glm::dvec3(glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722)));
}

ControlPoint emphasised(ControlPoint point, double share, double least) {
  point.color = glm::mix(greyOfColor(point.color), emphasisColor, share);
  point.opacity = glm::mix(faintest * point.opacity, std::max(point.opacity, least), share);
  return point;
}

ControlPoint between(const ControlPoint& a, const ControlPoint& b, double t) {
  return {glm::mix(a.value, b.value, t), glm::mix(a.color, b.color, t), glm::mix(a.opacity, b.opacity, t)};
}

} // namespace

double shareOfPoint(const TransferFunction& function, std::size_t point, double value) {
  assert(point < function.points.size());
  const auto& points = function.points;
  const double own = points[point].value;
  const bool isLast = point + 1 == points.size();
  if (value == own)
    return isLast || points[point + 1].value > own ? 1.0 : 0.0;
  if (value < own ? point == 0 : isLast)
    return 1.0;
  const double neighbour = points[value < own ? point - 1 : point + 1].value;
  const bool isBetween = value < own ? value > neighbour : value < neighbour;
  return isBetween ? (value - neighbour) / (own - neighbour) : 0.0;
}

TransferFunction withPointEmphasised(const TransferFunction& function, std::size_t point) {
  assert(point < function.points.size());
  TransferFunction result{function.unitDistanceMm, {}};
  const double least = function.points[point].opacity > 0.0 ? wellLit : 0.0;
  for (std::size_t i = 0; i < function.points.size(); ++i) {
    const ControlPoint& here = function.points[i];
    result.points.push_back(emphasised(here, i == point ? 1.0 : 0.0, least));
    const bool isBeside = i == point || i + 1 == point;
    if (!isBeside || i + 1 == function.points.size() || function.points[i + 1].value == here.value)
      continue;
    for (int part = 1; part < partsBetweenPoints; ++part) {
      const double t = static_cast<double>(part) / partsBetweenPoints;
      result.points.push_back(
          emphasised(between(here, function.points[i + 1], t), i == point ? 1.0 - t : t, least));
    }
  }
  return result;
}

} // namespace limn
