// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/canvas/CurveDrag.h"

#include "widgets/Gesture.h"
#include "widgets/ValueText.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double startDistance = 3.0; // pixels before a press becomes a drag
constexpr double pixelsPerDoubling = 120.0;

TransferFunction draggedPoints(const CurveDrag& drag, const PlotTransform& transform, QPointF travelled,
                               bool lockAxis) {
  if (lockAxis)
    (std::abs(travelled.x()) >= std::abs(travelled.y()) ? travelled.ry() : travelled.rx()) = 0.0;
  const ControlPoint& grabbed = drag.before.points[drag.grabbed];
  const double y = yOfOpacity(transform, grabbed.opacity) + travelled.y();
  // Without vertical travel keep the opacity to the last bit.
  const double opacityOffset = travelled.y() == 0.0 ? 0.0 : opacityAtY(transform, y) - grabbed.opacity;
  return withPointsMoved(drag.before, drag.moved, travelled.x() * valuePerPixel(transform), opacityOffset);
}

double widthFactor(const CurveDrag& drag, const PlotTransform& transform) {
  if (drag.fromGrip)
    return std::exp2(drag.travelled.x() / pixelsPerDoubling);
  const double centre = middleValue(drag.before);
  const double reach = drag.pressValue - centre;
  // An end cannot be pulled through the middle.
  return std::max(0.01, (reach + drag.travelled.x() * valuePerPixel(transform)) / reach);
}

} // namespace

CurveDrag begunDrag(CurveDrag::Kind kind, const TransferFunction& function, const PlotTransform& transform,
                    const QPointF& press) {
  CurveDrag drag;
  drag.kind = kind;
  drag.before = drag.restored = function;
  drag.press = drag.last = press;
  drag.pressValue = valueAtX(transform, press.x());
  drag.gestureId = nextGestureId();
  return drag;
}

CurveDrag begunDrag(const CurveHit& hit, const CurvePlot& plot, const PlotTransform& transform,
                    const QPointF& press, Qt::KeyboardModifiers modifiers) {
  CurveDrag drag = begunDrag(CurveDrag::Kind::band, plot.function, transform, press);
  switch (hit.part) {
  case CurveHit::Part::point:
    drag.kind = CurveDrag::Kind::points;
    drag.grabbed = hit.index;
    drag.moved = plot.selected;
    break;
  case CurveHit::Part::barGrip:
    drag.fromGrip = modifiers & Qt::AltModifier;
    drag.kind = drag.fromGrip ? CurveDrag::Kind::width : CurveDrag::Kind::shift;
    break;
  case CurveHit::Part::barEnd:
    drag.kind = CurveDrag::Kind::width;
    break;
  default:
    drag.selectedBefore = modifiers & Qt::ControlModifier ? plot.selected : PointIndices{};
  }
  return drag;
}

void travel(CurveDrag& drag, const QPointF& position, bool fine) {
  drag.travelled += (position - drag.last) * (fine ? 0.1 : 1.0);
  drag.last = position;
  const QPointF fromPress = position - drag.press;
  drag.started = drag.started || std::hypot(fromPress.x(), fromPress.y()) >= startDistance;
}

TransferFunction draggedFunction(const CurveDrag& drag, const PlotTransform& transform, bool lockAxis) {
  switch (drag.kind) {
  case CurveDrag::Kind::points:
    return draggedPoints(drag, transform, drag.travelled, lockAxis);
  case CurveDrag::Kind::shift:
    return shifted(drag.before, drag.travelled.x() * valuePerPixel(transform));
  case CurveDrag::Kind::width:
    return stretched(drag.before, middleValue(drag.before), widthFactor(drag, transform));
  default:
    return drag.before;
  }
}

PointIndices bandedPoints(const CurveDrag& drag, const PlotTransform& transform,
                          const TransferFunction& function) {
  PointIndices banded = pointsInside(transform, function, QRectF(drag.press, drag.last).normalized());
  for (const std::size_t index : drag.selectedBefore)
    banded = withIndex(banded, index);
  return banded;
}

QString dragText(const CurveDrag& drag, const TransferFunction& now, const QString& unit, int decimals) {
  if (drag.kind == CurveDrag::Kind::points) {
    const QString value = valueText(now.points[drag.grabbed].value, unit, decimals);
    return drag.added ? QObject::tr("add point at %1").arg(value) : movedText(drag.moved.size(), value);
  }
  if (drag.kind == CurveDrag::Kind::shift)
    return QObject::tr("shift curve by %1")
        .arg(valueText(middleValue(now) - middleValue(drag.before), unit, decimals));
  return QObject::tr("change width of curve");
}

} // namespace limn
