// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/PlotTransform.h"

#include "widgets/ValueText.h"

#include <QLineF>

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

double scaled(AxisScale scale, double value) {
  return scale == AxisScale::logarithmic ? std::log10(value)
         : scale == AxisScale::cubeRoot  ? std::cbrt(value)
                                         : value;
}

double unscaled(AxisScale scale, double place) {
  return scale == AxisScale::logarithmic ? std::pow(10.0, place)
         : scale == AxisScale::cubeRoot  ? place * place * place
                                         : place;
}

ValueRange scaled(AxisScale scale, const ValueRange& range) {
  return {scaled(scale, range.lowest), scaled(scale, range.highest)};
}

ValueRange keptWithin(const ValueRange& range, const ValueRange& full) {
  const double width = std::min(range.highest - range.lowest, full.highest - full.lowest);
  const double lowest = std::clamp(range.lowest, full.lowest, full.highest - width);
  return {lowest, lowest + width};
}

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

bool meets(const QLineF& line, const QRectF& box) {
  if (box.contains(line.p1()) || box.contains(line.p2()))
    return true;
  const std::array sides{QLineF(box.topLeft(), box.topRight()), QLineF(box.topRight(), box.bottomRight()),
                         QLineF(box.bottomRight(), box.bottomLeft()),
                         QLineF(box.bottomLeft(), box.topLeft())};
  return std::ranges::any_of(sides, [&](const QLineF& side) {
    return line.intersects(side, nullptr) == QLineF::BoundedIntersection;
  });
}

} // namespace

double xOfValue(const PlotTransform& t, double value) {
  const ValueRange ends = scaled(t.acrossScale, t.visible);
  return t.plot.left() +
         (scaled(t.acrossScale, value) - ends.lowest) / ((ends.highest - ends.lowest) / t.plot.width());
}

double valueAtX(const PlotTransform& t, double x) {
  const ValueRange ends = scaled(t.acrossScale, t.visible);
  return unscaled(t.acrossScale,
                  ends.lowest + (x - t.plot.left()) * ((ends.highest - ends.lowest) / t.plot.width()));
}

double yOfOpacity(const PlotTransform& t, double opacity) {
  const ValueRange ends = scaled(t.upScale, t.up);
  return t.plot.bottom() -
         (scaled(t.upScale, opacity) - ends.lowest) / (ends.highest - ends.lowest) * t.plot.height();
}

double opacityAtY(const PlotTransform& t, double y) {
  const ValueRange ends = scaled(t.upScale, t.up);
  const double height = std::clamp((t.plot.bottom() - y) / t.plot.height(), 0.0, 1.0);
  return unscaled(t.upScale, ends.lowest + height * (ends.highest - ends.lowest));
}

double valuePerPixel(const PlotTransform& t) {
  return (t.visible.highest - t.visible.lowest) / t.plot.width();
}

double roundedToPixel(const PlotTransform& t, double value) {
  const double places = std::pow(10.0, decimalsFor(valuePerPixel(t)));
  return std::round(value * places) / places;
}

ValueRange zoomedAtX(const PlotTransform& t, double x, double factor, const ValueRange& full) {
  const double fullWidth = full.highest - full.lowest;
  const double width =
      std::clamp((t.visible.highest - t.visible.lowest) / factor, fullWidth * 1e-5, fullWidth);
  const double share = std::clamp((x - t.plot.left()) / t.plot.width(), 0.0, 1.0);
  const double lowest = valueAtX(t, x) - share * width;
  return keptWithin({lowest, lowest + width}, full);
}

ValueRange pannedBy(const PlotTransform& t, double pixels, const ValueRange& full) {
  const double offset = pixels * valuePerPixel(t);
  return keptWithin({t.visible.lowest + offset, t.visible.highest + offset}, full);
}

ValueRange revealed(const PlotTransform& t, double value, double margin, const ValueRange& full) {
  const double x = xOfValue(t, value);
  if (x >= t.plot.left() && x <= t.plot.right())
    return t.visible;
  return pannedBy(t, x < t.plot.left() ? x - t.plot.left() - margin : x - t.plot.right() + margin, full);
}

std::optional<std::size_t> nearestPlace(const std::vector<QPointF>& places, const QPointF& position,
                                        double radius) {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double d = distance(position, places[i]);
    if (d > radius)
      continue;
    radius = d;
    nearest = i;
  }
  return nearest;
}

double distanceToLine(const QPolygonF& line, const QPointF& position) {
  double nearest = 1e9;
  for (int i = 1; i < line.size(); ++i)
    nearest = std::min(nearest, distanceToSegment(position, line[i - 1], line[i]));
  return nearest;
}

bool runsThrough(const QPolygonF& line, const QRectF& box) {
  for (qsizetype i = 1; i < line.size(); ++i)
    if (meets({line[i - 1], line[i]}, box))
      return true;
  return false;
}

} // namespace limn
