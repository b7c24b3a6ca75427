// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/picture/CurveGeometry.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double pointHitRadius = 10.0;  // pixels, so the hit area is 20 wide
constexpr double curveHitDistance = 6.0; // pixels
constexpr double handleHitRadius = 10.0; // pixels

constexpr double barAbovePlot = 9.0;
constexpr double gripInset = 24.0; // from the plot's edge: half the grip and the arrow beside it

// On the cube-root axis a straight ramp is a curve: refine it every few pixels.
void appendRamp(QPolygonF& polygon, const PlotTransform& transform, const QPointF& fromValue,
                const QPointF& toValue) {
  const double pixels = (toValue.x() - fromValue.x()) / valuePerPixel(transform);
  const int pieces = transform.upScale == AxisScale::cubeRoot && fromValue.y() != toValue.y()
                         ? std::max(1, static_cast<int>(std::ceil(pixels / 3.0)))
                         : 1;
  for (int i = 1; i <= pieces; ++i) {
    // Crowd the pieces where the cube root bends most: towards the lower end.
    const double even = static_cast<double>(i) / pieces;
    const double share = fromValue.y() < toValue.y() ? even * even : 1.0 - (1.0 - even) * (1.0 - even);
    const QPointF value = fromValue + share * (toValue - fromValue);
    polygon << QPointF(xOfValue(transform, value.x()), yOfOpacity(transform, value.y()));
  }
}

} // namespace

QPointF positionOf(const PlotTransform& transform, const ControlPoint& point) {
  return {xOfValue(transform, point.value), yOfOpacity(transform, point.opacity)};
}

QPolygonF curvePolygon(const PlotTransform& transform, const TransferFunction& function) {
  QPolygonF polygon;
  if (function.points.empty())
    return polygon;
  const ValueRange& visible = transform.visible;
  QPointF last(visible.lowest, classify(function, visible.lowest).opacity);
  polygon << QPointF(xOfValue(transform, last.x()), yOfOpacity(transform, last.y()));
  for (const ControlPoint& point : function.points) {
    if (point.value <= visible.lowest || point.value >= visible.highest)
      continue;
    const QPointF next(point.value, point.opacity);
    appendRamp(polygon, transform, last, next);
    last = next;
  }
  appendRamp(polygon, transform, last, {visible.highest, classify(function, visible.highest).opacity});
  return polygon;
}

std::optional<CurveBar> curveBar(const PlotTransform& transform, const TransferFunction& function) {
  if (function.points.empty())
    return std::nullopt;
  const QRectF& plot = transform.plot;
  const double y = plot.top() - barAbovePlot;
  const auto placeOf = [&](double value, double inset) {
    const double room = std::min(inset, plot.width() / 2.0);
    return QPointF(std::clamp(xOfValue(transform, value), plot.left() + room, plot.right() - room), y);
  };
  const auto isVisible = [&](double value) {
    return value >= transform.visible.lowest && value <= transform.visible.highest;
  };
  const double first = function.points.front().value;
  const double last = function.points.back().value;
  return CurveBar{placeOf(first, 0.0), placeOf(middleValue(function), gripInset), placeOf(last, 0.0),
                  isVisible(first), isVisible(last)};
}

CurveHit hitAt(const PlotTransform& transform, const TransferFunction& function, const QPointF& position) {
  const auto isWithin = [&](const QPointF& place) {
    return QLineF(position, place).length() <= handleHitRadius;
  };
  if (const auto bar = curveBar(transform, function)) {
    // The bar has its own lane above the plot; a point at full opacity keeps the pixels inside the plot.
    if (position.y() < transform.plot.top() - 2.0) {
      if (isWithin(bar->grip))
        return {CurveHit::Part::barGrip, 0};
      const bool onStart = bar->startVisible && isWithin(bar->start);
      const bool onEnd = bar->endVisible && isWithin(bar->end);
      if (function.points.size() > 1 && (onStart || onEnd))
        return {CurveHit::Part::barEnd, 0};
    }
  }
  std::vector<QPointF> points;
  for (const ControlPoint& point : function.points)
    points.push_back(positionOf(transform, point));
  if (const auto point = nearestPlace(points, position, pointHitRadius))
    return {CurveHit::Part::point, *point};
  if (transform.plot.adjusted(0.0, -2.0, 0.0, 2.0).contains(position) &&
      distanceToLine(curvePolygon(transform, function), position) <= curveHitDistance)
    return {CurveHit::Part::curve, 0};
  return {};
}

PointIndices pointsInside(const PlotTransform& transform, const TransferFunction& function,
                          const QRectF& band) {
  PointIndices inside;
  for (std::size_t i = 0; i < function.points.size(); ++i)
    if (band.contains(positionOf(transform, function.points[i])))
      inside.push_back(i);
  return inside;
}

} // namespace limn
