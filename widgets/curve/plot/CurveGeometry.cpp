// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/plot/CurveGeometry.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double barAbovePlot = 9.0;
constexpr double gripInset = 24.0; // from the plot's edge: half the grip and the arrow beside it

double distance(const QPointF& a, const QPointF& b) {
  return QLineF(a, b).length();
}

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
  const QPointF along = b - a;
  const double squared = QPointF::dotProduct(along, along);
  const double share =
      squared > 0.0 ? std::clamp(QPointF::dotProduct(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return distance(p, a + share * along);
}

double distanceToCurve(const PlotTransform& transform, const TransferFunction& function, const QPointF& p) {
  const QPolygonF polygon = curvePolygon(transform, function);
  double nearest = 1e9;
  for (int i = 1; i < polygon.size(); ++i)
    nearest = std::min(nearest, distanceToSegment(p, polygon[i - 1], polygon[i]));
  return nearest;
}

// On the cube-root axis a straight ramp is a curve: refine it every few pixels.
void appendRamp(QPolygonF& polygon, const PlotTransform& transform, const QPointF& fromValue,
                const QPointF& toValue) {
  const double pixels = (toValue.x() - fromValue.x()) / valuePerPixel(transform);
  const int pieces = transform.fineLowOpacities && fromValue.y() != toValue.y()
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

std::optional<std::size_t> nearestPoint(const PlotTransform& transform, const TransferFunction& function,
                                        const QPointF& position) {
  std::optional<std::size_t> nearest;
  double best = pointHitRadius;
  for (std::size_t i = 0; i < function.points.size(); ++i) {
    const double d = distance(position, positionOf(transform, function.points[i]));
    if (d > best)
      continue;
    best = d;
    nearest = i; // of points on one spot the last, which is painted on top
  }
  return nearest;
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
  if (const auto bar = curveBar(transform, function)) {
    // The bar has its own lane above the plot; a point at full opacity keeps the pixels inside the plot.
    if (position.y() < transform.plot.top() - 2.0) {
      if (distance(position, bar->grip) <= handleHitRadius)
        return {CurveHit::Part::barGrip, 0};
      const bool onStart = bar->startVisible && distance(position, bar->start) <= handleHitRadius;
      const bool onEnd = bar->endVisible && distance(position, bar->end) <= handleHitRadius;
      if (function.points.size() > 1 && (onStart || onEnd))
        return {CurveHit::Part::barEnd, 0};
    }
  }
  if (const auto point = nearestPoint(transform, function, position))
    return {CurveHit::Part::point, *point};
  if (transform.plot.adjusted(0.0, -2.0, 0.0, 2.0).contains(position) &&
      distanceToCurve(transform, function, position) <= curveHitDistance)
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
