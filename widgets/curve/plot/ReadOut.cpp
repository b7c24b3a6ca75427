// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/plot/ReadOut.h"

#include "widgets/ValueText.h"

#include <QLineF>
#include <QObject>

#include <algorithm>
#include <array>

namespace limn {
namespace {

constexpr double besideValue = 12.0; // from the value's line, pixels
constexpr double fromEdge = 2.0;     // of the plot
constexpr double fromCurve = 2.0;

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

bool coversCurve(const QRectF& box, const QPolygonF& curve) {
  const QRectF kept = box.adjusted(-fromCurve, -fromCurve, fromCurve, fromCurve);
  for (qsizetype i = 1; i < curve.size(); ++i)
    if (meets({curve[i - 1], curve[i]}, kept))
      return true;
  return false;
}

bool coversPoint(const QRectF& box, const PlotTransform& transform, const TransferFunction& function) {
  constexpr double reach = pointDiameter / 2.0 + fromCurve;
  const QRectF kept = box.adjusted(-reach, -reach, reach, reach);
  return std::ranges::any_of(function.points, [&](const ControlPoint& point) {
    return kept.contains(positionOf(transform, point));
  });
}

const ControlPoint* toldPoint(const CanvasPicture& picture) {
  const std::vector<ControlPoint>& points = picture.function.points;
  return picture.readOut && *picture.readOut < points.size() ? &points[*picture.readOut] : nullptr;
}

} // namespace

std::optional<double> toldValue(const CanvasPicture& picture) {
  const ControlPoint* point = toldPoint(picture);
  return point ? std::optional(point->value) : picture.hoveredValue;
}

std::optional<Tissue> toldTissue(const CanvasPicture& picture) {
  const std::optional<double> value = toldValue(picture);
  return value && picture.unit == QLatin1String("HU") ? tissueAt(*value) : std::nullopt;
}

QString readOutText(const CanvasPicture& picture) {
  const std::optional<double> value = toldValue(picture);
  if (!value)
    return {};
  QString text = valueText(*value, picture.unit, picture.decimals);
  if (const ControlPoint* point = toldPoint(picture)) // of points at one value each has its own opacity
    text += QObject::tr(" · opacity %1").arg(opacityText(point->opacity));
  else if (!picture.function.points.empty())
    text += QObject::tr(" · opacity %1").arg(opacityText(classify(picture.function, *value).opacity));
  if (const std::optional<Tissue> tissue = toldTissue(picture))
    text += QStringLiteral(" · ") + tissue->name;
  return text;
}

QRectF clearPlace(const PlotTransform& transform, const TransferFunction& function, const QSizeF& size,
                  double x) {
  const QRectF room = transform.plot.adjusted(fromEdge, fromEdge, -fromEdge, -fromEdge);
  const QPolygonF curve = curvePolygon(transform, function);
  const auto boxAt = [&](double left, double top) {
    const double rightmost = std::max(room.left(), room.right() - size.width());
    return QRectF(QPointF(std::clamp(left, room.left(), rightmost), top), size);
  };
  const double bottom = room.bottom() - size.height();
  std::vector<double> tops{room.top(), bottom};
  for (double top = room.top() + size.height(); top < bottom; top += size.height())
    tops.push_back(top);
  std::optional<QRectF> besidePoints;
  for (const double top : tops)
    for (const double left : {x - size.width() / 2.0, x + besideValue, x - besideValue - size.width()}) {
      const QRectF box = boxAt(left, top);
      if (coversPoint(box, transform, function))
        continue;
      if (!coversCurve(box, curve))
        return box;
      besidePoints = besidePoints.value_or(box);
    }
  return besidePoints.value_or(boxAt(x - size.width() / 2.0, room.top()));
}

QRectF placeAbove(const PlotTransform& transform, const TransferFunction& function, const QSizeF& size,
                  const QPointF& centre) {
  const QRectF room = transform.plot.adjusted(fromEdge, fromEdge, -fromEdge, -fromEdge);
  const double left = std::clamp(centre.x() - size.width() / 2.0, room.left(),
                                 std::max(room.left(), room.right() - size.width()));
  const QRectF above(QPointF(left, centre.y() - besideValue - size.height()), size);
  return room.contains(above) && !coversPoint(above, transform, function)
             ? above
             : clearPlace(transform, function, size, centre.x());
}

} // namespace limn
