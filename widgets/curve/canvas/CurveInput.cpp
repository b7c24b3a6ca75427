// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/canvas/CurveInput.h"

#include "widgets/Gesture.h"
#include "widgets/ValueText.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QKeyEvent>
#include <QMenu>
#include <QObject>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double zoomPerNotch = 1.25;
constexpr double pixelsPerNotch = 80.0;

double notches(const QWheelEvent& event) {
  // Shift and Alt turn the wheel's axis on some platforms.
  const QPoint delta = event.angleDelta();
  return (std::abs(delta.y()) >= std::abs(delta.x()) ? delta.y() : delta.x()) / 120.0;
}

bool hasControl(const QKeyEvent& event) {
  return event.modifiers() & Qt::ControlModifier;
}

bool movesTheView(const QKeyEvent& event) {
  switch (event.key()) {
  case Qt::Key_Plus:
  case Qt::Key_Equal: // + without Shift on many keyboards
  case Qt::Key_Minus:
  case Qt::Key_Left:
  case Qt::Key_Right:
  case Qt::Key_0:
    return hasControl(event);
  default:
    return false;
  }
}

void addPointActions(QMenu& menu, TransferFunctionCanvas& canvas, std::size_t index) {
  if (!contains(canvas.selected(), index))
    canvas.selectPoints({index});
  const std::size_t count = canvas.selected().size();
  QAction* deletion = menu.addAction(
      count > 1 ? TransferFunctionCanvas::tr("Delete %1 points").arg(count)
                : TransferFunctionCanvas::tr("Delete"),
      &canvas, [&canvas] { canvas.apply(withoutSelected(canvas.plot(), canvas.shownDecimals())); });
  deletion->setEnabled(canvas.transferFunction().points.size() > 1);
  menu.addAction(hasColors(canvas.subject()) ? TransferFunctionCanvas::tr("Colour and numbers…")
                                             : TransferFunctionCanvas::tr("Numbers…"),
                 &canvas, [&canvas, index] { emit canvas.pointDetailsRequested(index); });
}

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
  double value = grabbed.value + travelled.x() * valuePerPixel(transform);
  if (!drag.isFine) // as the value is told
    value = roundedToPixel(transform, value);
  // Without horizontal travel keep the value to the last bit, too.
  const double valueOffset = travelled.x() == 0.0 ? 0.0 : value - grabbed.value;
  return withPointsMoved(drag.before, drag.moved, valueOffset, opacityOffset);
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

CurveKey curveKeyOf(const QKeyEvent& event, bool anySelected) {
  switch (event.key()) {
  case Qt::Key_A:
    return hasControl(event) ? CurveKey::selectAll : CurveKey::none;
  case Qt::Key_D:
    return hasControl(event) ? CurveKey::selectNone : CurveKey::none;
  case Qt::Key_Escape:
    return anySelected ? CurveKey::selectNone : CurveKey::none;
  case Qt::Key_Delete:
  case Qt::Key_Backspace:
    return anySelected && !hasControl(event) ? CurveKey::deleteSelected : CurveKey::none;
  case Qt::Key_Insert:
  case Qt::Key_N:
    return hasControl(event) ? CurveKey::none : CurveKey::addPoint;
  case Qt::Key_Return:
  case Qt::Key_Enter:
    return hasControl(event) ? CurveKey::none : CurveKey::typeNumbers;
  default:
    return anySelected && !arrowOf(event).isNull() ? CurveKey::nudge : CurveKey::none;
  }
}

bool comesBeforeShortcuts(const QKeyEvent& event, bool anySelected) {
  if (hasControl(event))
    return event.key() == Qt::Key_A || event.key() == Qt::Key_D || movesTheView(event);
  const CurveKey key = curveKeyOf(event, anySelected);
  return key == CurveKey::addPoint || (anySelected && key != CurveKey::none);
}

QPointF arrowOf(const QKeyEvent& event) {
  const double reach = (event.modifiers() & Qt::ShiftModifier ? 10.0 : 1.0) *
                       (event.modifiers() & Qt::AltModifier ? 0.1 : 1.0);
  switch (event.key()) {
  case Qt::Key_Left:
    return {-reach, 0.0};
  case Qt::Key_Right:
    return {reach, 0.0};
  case Qt::Key_Up:
    return {0.0, reach};
  case Qt::Key_Down:
    return {0.0, -reach};
  default:
    return {};
  }
}

ValueRange wheeledView(const PlotTransform& transform, const QWheelEvent& event, const ValueRange& full) {
  if (event.modifiers() & Qt::ShiftModifier)
    return pannedBy(transform, -pixelsPerNotch * notches(event), full);
  return zoomedAtX(transform, event.position().x(), std::pow(zoomPerNotch, notches(event)), full);
}

std::optional<ValueRange> keyedView(const PlotTransform& transform, const QKeyEvent& event,
                                    const CurvePlot& plot) {
  if (!movesTheView(event))
    return std::nullopt;
  const ValueRange full = fullRange(plot);
  const double about = plot.selected.empty()
                           ? transform.plot.center().x()
                           : xOfValue(transform, plot.function.points[plot.selected.front()].value);
  switch (event.key()) {
  case Qt::Key_0:
    return full;
  case Qt::Key_Left:
    return pannedBy(transform, -pixelsPerNotch, full);
  case Qt::Key_Right:
    return pannedBy(transform, pixelsPerNotch, full);
  case Qt::Key_Minus:
    return zoomedAtX(transform, about, 1.0 / zoomPerNotch, full);
  default:
    return zoomedAtX(transform, about, zoomPerNotch, full);
  }
}

Qt::CursorShape cursorFor(CurveHit::Part part) {
  switch (part) {
  case CurveHit::Part::point:
    return Qt::PointingHandCursor;
  case CurveHit::Part::curve:
    return Qt::CrossCursor;
  case CurveHit::Part::barGrip:
  case CurveHit::Part::barEnd:
    return Qt::SizeHorCursor;
  default:
    return Qt::ArrowCursor;
  }
}

void openCurveMenu(TransferFunctionCanvas& canvas, const QPointF& position) {
  auto* menu = new QMenu(&canvas);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const CurveHit hit = hitAt(canvas.transform(), canvas.transferFunction(), position);
  if (hit.part == CurveHit::Part::point)
    addPointActions(*menu, canvas, hit.index);
  else
    menu->addAction(TransferFunctionCanvas::tr("Add point here"), &canvas,
                    [&canvas, position] { canvas.addPoint(position); });
  menu->addSeparator();
  menu->addAction(TransferFunctionCanvas::tr("Select all points"), &canvas,
                  [&canvas] { canvas.selectPoints(allPoints(canvas.transferFunction())); });
  menu->addAction(TransferFunctionCanvas::tr("Show all values"), &canvas, &TransferFunctionCanvas::resetView);
  if (canvas.hasPin())
    menu->addAction(TransferFunctionCanvas::tr("Remove the pin"), &canvas,
                    [&canvas] { canvas.setPinnedValue(std::nullopt); });
  menu->popup(canvas.mapToGlobal(position.toPoint()));
}

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
  drag.isFine = drag.isFine || fine;
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
