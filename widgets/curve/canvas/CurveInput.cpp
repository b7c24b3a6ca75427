// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/canvas/CurveInput.h"

#include <QKeyEvent>
#include <QWheelEvent>

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

} // namespace limn
