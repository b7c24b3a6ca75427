// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QMouseEvent>
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

} // namespace

void TransferFunctionCanvas::mousePressEvent(QMouseEvent* event) {
  if (m_drag.kind != CurveDrag::Kind::none)
    return;
  const bool middle = event->button() == Qt::MiddleButton;
  if (middle || (event->button() == Qt::LeftButton && m_spaceHeld)) {
    beginDrag(CurveDrag::Kind::pan, event->position());
    setCursor(Qt::ClosedHandCursor);
  } else if (event->button() == Qt::LeftButton) {
    pressLeft(*event);
  }
}

void TransferFunctionCanvas::pressLeft(const QMouseEvent& event) {
  m_addedByPress.reset();
  const CurveHit hit = hitAt(transform(), m_function, event.position());
  switch (hit.part) {
  case CurveHit::Part::point:
    return pressPoint(hit.index, event);
  case CurveHit::Part::curve:
    return pressCurve(event.position());
  case CurveHit::Part::barGrip:
    m_drag.fromGrip = event.modifiers() & Qt::AltModifier;
    return beginDrag(m_drag.fromGrip ? CurveDrag::Kind::width : CurveDrag::Kind::shift, event.position());
  case CurveHit::Part::barEnd:
    return beginDrag(CurveDrag::Kind::width, event.position());
  case CurveHit::Part::nothing:
    m_drag.selectedBefore = event.modifiers() & Qt::ControlModifier ? m_selected : PointIndices{};
    return beginDrag(CurveDrag::Kind::band, event.position());
  }
}

void TransferFunctionCanvas::pressPoint(std::size_t index, const QMouseEvent& event) {
  if (event.modifiers() & Qt::ControlModifier) {
    PointIndices toggled = m_selected;
    if (std::erase(toggled, index) == 0)
      toggled.insert(std::upper_bound(toggled.begin(), toggled.end(), index), index);
    return selectPoints(toggled);
  }
  if (!isSelected(index))
    selectPoints({index});
  m_drag.grabbed = index;
  m_drag.moved = m_selected;
  beginDrag(CurveDrag::Kind::points, event.position());
}

void TransferFunctionCanvas::pressCurve(const QPointF& position) {
  const PlotTransform plot = transform();
  const double value = std::max(valueAtX(plot, position.x()), lowestPlace(m_subject));
  std::size_t index = 0;
  const TransferFunction before = m_function;
  const TransferFunction added =
      withPointAdded(m_function, value, classify(m_function, value).opacity, &index);
  const std::uint64_t id = nextGestureId();
  edit(added, {id, tr("add point at %1").arg(textOf(value))});
  selectPoints({index});
  m_addedByPress = index;
  m_drag.grabbed = index;
  m_drag.moved = {index};
  beginDrag(CurveDrag::Kind::points, position);
  m_drag.added = true;
  m_drag.restored = before;
  m_drag.gestureId = id;
}

void TransferFunctionCanvas::beginDrag(CurveDrag::Kind kind, const QPointF& position) {
  m_drag.kind = kind;
  m_drag.before = m_drag.restored = m_function;
  m_drag.press = m_drag.last = position;
  m_drag.pressValue = valueAtX(transform(), position.x());
  m_drag.gestureId = nextGestureId();
  m_hoveredValue.reset();
  update();
}

void TransferFunctionCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (m_drag.kind == CurveDrag::Kind::none)
    hover(event->position());
  else
    continueDrag(*event);
}

void TransferFunctionCanvas::continueDrag(const QMouseEvent& event) {
  const PlotTransform plot = transform();
  const QPointF last = m_drag.last;
  const bool movesPoints = m_drag.kind == CurveDrag::Kind::points;
  travel(m_drag, event.position(), movesPoints && event.modifiers() & Qt::AltModifier);
  if (!m_drag.started)
    return;
  if (m_drag.kind == CurveDrag::Kind::pan)
    return showView(pannedBy(plot, last.x() - event.position().x(), fullRange()));
  if (m_drag.kind == CurveDrag::Kind::band) {
    PointIndices inside = pointsInside(plot, m_function, QRectF(m_drag.press, event.position()).normalized());
    for (const std::size_t i : m_drag.selectedBefore)
      if (std::find(inside.begin(), inside.end(), i) == inside.end())
        inside.push_back(i);
    std::sort(inside.begin(), inside.end());
    selectPoints(inside);
    return update();
  }
  const TransferFunction now =
      limitedTo(m_subject, draggedFunction(m_drag, plot, event.modifiers() & Qt::ShiftModifier));
  edit(now, {m_drag.gestureId, dragText(m_drag, now, m_unit, shownDecimals())});
}

void TransferFunctionCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton && m_drag.kind == CurveDrag::Kind::none)
    return showMenu(event->position().toPoint());
  const CurveHit hit = hitAt(transform(), m_function, event->position());
  const bool middleClick =
      event->button() == Qt::MiddleButton && m_drag.kind == CurveDrag::Kind::pan && !m_drag.started;
  endDrag();
  if (middleClick && hit.part == CurveHit::Part::point) {
    selectPoints({hit.index});
    deleteSelected();
  }
  hover(event->position());
}

void TransferFunctionCanvas::endDrag() {
  const CurveDrag ended = m_drag;
  m_drag = {};
  if (!ended.started && ended.kind == CurveDrag::Kind::band)
    selectPoints(ended.selectedBefore);
  if (!ended.started && ended.kind == CurveDrag::Kind::points)
    selectPoints({ended.grabbed});
  update();
}

void TransferFunctionCanvas::cancelDrag() {
  const CurveDrag cancelled = m_drag;
  m_drag = {};
  edit(cancelled.restored, {cancelled.gestureId, dragText(cancelled, m_function, m_unit, shownDecimals())});
  update();
}

void TransferFunctionCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  const PlotTransform plot = transform();
  const CurveHit hit = hitAt(plot, m_function, event->position());
  if (hit.part == CurveHit::Part::point) {
    if (hit.index != m_addedByPress)
      emit pointDetailsRequested(hit.index);
  } else if (plot.plot.contains(event->position())) {
    addPoint(event->position());
  } else if (hit.part == CurveHit::Part::nothing) {
    resetView();
  }
}

void TransferFunctionCanvas::addPoint(const QPointF& position) {
  const PlotTransform plot = transform();
  const double value = std::max(valueAtX(plot, position.x()), lowestPlace(m_subject));
  std::size_t index = 0;
  const TransferFunction added = withPointAdded(m_function, value, opacityAtY(plot, position.y()), &index);
  edit(added, {nextGestureId(), tr("add point at %1").arg(textOf(value))});
  selectPoints({index});
}

void TransferFunctionCanvas::wheelEvent(QWheelEvent* event) {
  if (m_drag.kind != CurveDrag::Kind::none)
    return;
  const PlotTransform plot = transform();
  if (event->modifiers() & Qt::ShiftModifier)
    showView(pannedBy(plot, -pixelsPerNotch * notches(*event), fullRange()));
  else
    showView(zoomedAtX(plot, event->position().x(), std::pow(zoomPerNotch, notches(*event)), fullRange()));
  hover(event->position());
  event->accept();
}

void TransferFunctionCanvas::hover(const QPointF& position) {
  const PlotTransform plot = transform();
  m_hovered = hitAt(plot, m_function, position);
  const std::optional<double> value =
      plot.plot.contains(position) ? std::optional(valueAtX(plot, position.x())) : std::nullopt;
  setCursor(m_spaceHeld ? Qt::OpenHandCursor : cursorFor(m_hovered.part));
  update();
  if (value == m_hoveredValue)
    return;
  m_hoveredValue = value;
  emit valueHovered(value);
}

void TransferFunctionCanvas::leaveEvent(QEvent*) {
  m_hovered = {};
  update();
  if (!m_hoveredValue)
    return;
  m_hoveredValue.reset();
  emit valueHovered(std::nullopt);
}

void TransferFunctionCanvas::showMenu(const QPoint& position) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const CurveHit hit = hitAt(transform(), m_function, position);
  if (hit.part == CurveHit::Part::point)
    addPointActions(*menu, hit.index);
  else
    menu->addAction(tr("Add point here"), this, [this, position] { addPoint(position); });
  menu->addSeparator();
  menu->addAction(tr("Select all points"), this, &TransferFunctionCanvas::selectAll);
  menu->addAction(tr("Show all values"), this, &TransferFunctionCanvas::resetView);
  if (m_pinnedValue)
    menu->addAction(tr("Remove the pin"), this, [this] { setPinnedValue(std::nullopt); });
  menu->popup(mapToGlobal(position));
}

void TransferFunctionCanvas::addPointActions(QMenu& menu, std::size_t index) {
  if (!isSelected(index))
    selectPoints({index});
  const QString text = m_selected.size() > 1 ? tr("Delete %1 points").arg(m_selected.size()) : tr("Delete");
  QAction* deletion = menu.addAction(text, this, &TransferFunctionCanvas::deleteSelected);
  deletion->setEnabled(m_function.points.size() > 1);
  menu.addAction(hasColors(m_subject) ? tr("Colour and numbers…") : tr("Numbers…"), this,
                 [this, index] { emit pointDetailsRequested(index); });
}

void TransferFunctionCanvas::contextMenuEvent(QContextMenuEvent* event) {
  // The mouse opens the menu on release, on every platform alike; here only the menu key counts.
  if (event->reason() != QContextMenuEvent::Keyboard)
    return;
  const QPointF place = m_selected.empty() ? transform().plot.center()
                                           : positionOf(transform(), m_function.points[m_selected.front()]);
  showMenu(place.toPoint());
}

} // namespace limn
