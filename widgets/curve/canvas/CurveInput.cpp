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
  case Qt::Key_Return:
  case Qt::Key_Enter:
    return hasControl(event) ? CurveKey::none : CurveKey::typeNumbers;
  default:
    return anySelected && !arrowOf(event).isNull() ? CurveKey::nudge : CurveKey::none;
  }
}

bool comesBeforeShortcuts(const QKeyEvent& event, bool anySelected) {
  if (hasControl(event))
    return event.key() == Qt::Key_A || event.key() == Qt::Key_D;
  return anySelected && curveKeyOf(event, anySelected) != CurveKey::none;
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
