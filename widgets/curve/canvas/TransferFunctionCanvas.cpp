// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include "widgets/ValueText.h"
#include "widgets/curve/canvas/AccessibleCanvas.h"
#include "widgets/curve/canvas/CurveInput.h"
#include "widgets/curve/picture/CanvasPicture.h"

#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QPainter>

#include <utility>

namespace limn {

TransferFunctionCanvas::TransferFunctionCanvas(CurveSubject subject, QWidget* parent)
    : QWidget(parent), m_plot{.subject = subject, .function = {}, .selected = {}, .values = {}, .unit = {}} {
  makeCanvasesAccessible();
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(subject == CurveSubject::value ? tr("Transfer function curve")
                                                   : tr("Curve of opacity over the gradient"));
  setAccessibleDescription(
      tr("Tab walks the points, arrows move them, N adds one, Enter edits numbers, Delete removes, Ctrl+A "
         "selects all."));
}

void TransferFunctionCanvas::setTransferFunction(const TransferFunction& function) {
  if (function == m_plot.function)
    return;
  // What comes from elsewhere (undo, a preset) ends a drag that worked on something else.
  m_drag = {};
  m_hovered = {};
  if (function.points.size() != m_plot.function.points.size())
    m_plot.selected.clear();
  const TransferFunction before = std::exchange(m_plot.function, function);
  if (!m_plot.values)
    resetView();
  update();
  tellPoints(*this, before);
}

void TransferFunctionCanvas::setHistogram(const Histogram& histogram) {
  const auto values = histogram.counts.empty() ? std::nullopt : std::optional(histogram.range);
  m_histogram.setHistogram(histogram);
  if (std::exchange(m_plot.values, values) != values)
    resetView();
  update();
}

PlotTransform TransferFunctionCanvas::transform() const {
  return {plotWithin(size(), m_plot.subject), m_visible,
          m_fineLowOpacities ? AxisScale::cubeRoot : AxisScale::linear};
}

int TransferFunctionCanvas::shownDecimals() const {
  return decimalsFor(valuePerPixel(transform()));
}

void TransferFunctionCanvas::resetView() {
  setShown(m_visible, fullRange(m_plot));
}

void TransferFunctionCanvas::selectPoints(const PointIndices& indices) {
  if (indices == m_plot.selected)
    return;
  m_plot.selected = indices;
  update();
  emit selectionChanged();
  tellPointFocus(*this);
}

std::optional<std::size_t> TransferFunctionCanvas::focusedPoint() const {
  return hasFocus() && !m_plot.selected.empty() ? std::optional(m_plot.selected.front()) : std::nullopt;
}

void TransferFunctionCanvas::takeInHand(std::size_t index) {
  selectPoints({index});
  revealSelected();
}

void TransferFunctionCanvas::placePoint(std::size_t index, double value, double opacity) {
  if (isDragging())
    return;
  apply(withPointPlaced(m_plot, index, value, opacity, shownDecimals()));
  revealSelected();
}

// Several points may lie too far apart for one view.
void TransferFunctionCanvas::revealSelected() {
  if (m_plot.selected.size() == 1)
    setShown(m_visible, revealed(transform(), m_plot.function.points[m_plot.selected.front()].value,
                                 2.0 * pointDiameter, fullRange(m_plot)));
}

void TransferFunctionCanvas::apply(const CurveChange& change, std::optional<std::uint64_t> gestureId) {
  edit(change.function, {gestureId ? *gestureId : nextGestureId(), change.text});
  selectPoints(change.selected);
}

void TransferFunctionCanvas::edit(const TransferFunction& wanted, const Gesture& gesture) {
  const TransferFunction function = limitedTo(m_plot.subject, wanted);
  if (function == m_plot.function)
    return;
  const bool sameCount = function.points.size() == m_plot.function.points.size();
  const TransferFunction before = std::exchange(m_plot.function, function);
  if (!sameCount) {
    m_hovered = {};
    selectPoints({});
  }
  update();
  tellPoints(*this, before);
  emit transferFunctionEdited(function, gesture);
}

CanvasPicture TransferFunctionCanvas::picture() {
  CanvasPicture picture;
  picture.subject = m_plot.subject;
  picture.function = m_plot.function;
  picture.transform = transform();
  picture.colors = themeColors(palette());
  picture.unit = m_plot.unit;
  picture.decimals = shownDecimals();
  picture.histogram = m_histogram.picture(picture.transform, picture.colors, devicePixelRatioF());
  picture.hint = m_hint.isEmpty() && !m_plot.values ? tr("Open a volume to see its histogram") : m_hint;
  picture.selected = m_plot.selected;
  picture.hoveredValue = m_hoveredValue;
  picture.mark = m_mark;
  picture.pinnedValue = m_pinnedValue;
  picture.hoveredPart = m_hovered.part;
  picture.focused = hasFocus();
  if (m_hovered.part == CurveHit::Part::point)
    picture.hoveredPoint = picture.readOut = m_hovered.index;
  else if (!m_hoveredValue && m_plot.selected.size() == 1)
    picture.readOut = focusedPoint();
  if (m_drag.kind == CurveDrag::Kind::points)
    picture.readOut = m_drag.grabbed;
  if (m_drag.kind == CurveDrag::Kind::band && m_drag.started)
    picture.band = QRectF(m_drag.press, m_drag.last).normalized() &
                   picture.transform.plot.adjusted(-6.0, -6.0, 6.0, 6.0);
  return picture;
}

void TransferFunctionCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.92);
  painter.setFont(small);
  const CanvasPicture shown = picture();
  paintAxes(painter, shown);
  paintCurve(painter, shown);
}

void TransferFunctionCanvas::mousePressEvent(QMouseEvent* event) {
  if (isDragging())
    return;
  const bool left = event->button() == Qt::LeftButton;
  if (event->button() == Qt::MiddleButton || (left && m_spaceHeld)) {
    begin(begunDrag(CurveDrag::Kind::pan, m_plot.function, transform(), event->position()));
    setCursor(Qt::ClosedHandCursor);
  } else if (left) {
    press(hitAt(transform(), m_plot.function, event->position()), *event);
  }
}

void TransferFunctionCanvas::press(const CurveHit& hit, const QMouseEvent& event) {
  m_addedByPress.reset();
  m_inHandBefore.clear();
  if (hit.part == CurveHit::Part::curve)
    return pressCurve(event.position());
  const bool isSelected = contains(m_plot.selected, hit.index);
  if (hit.part == CurveHit::Part::point && event.modifiers() & Qt::ControlModifier)
    return selectPoints(isSelected ? withoutIndex(m_plot.selected, hit.index)
                                   : withIndex(m_plot.selected, hit.index));
  if (hit.part == CurveHit::Part::point && !isSelected)
    selectPoints({hit.index});
  begin(begunDrag(hit, m_plot, transform(), event.position(), event.modifiers()));
}

void TransferFunctionCanvas::pressCurve(const QPointF& position) {
  const TransferFunction before = m_plot.function;
  const PlotTransform plot = transform();
  const double value =
      std::max(roundedToPixel(plot, valueAtX(plot, position.x())), lowestPlace(m_plot.subject));
  const CurveChange added = withPointAt(m_plot, value, classify(before, value).opacity, shownDecimals());
  const std::uint64_t id = nextGestureId();
  apply(added, id);
  m_addedByPress = added.selected.front();
  CurveDrag drag =
      begunDrag({CurveHit::Part::point, *m_addedByPress}, m_plot, plot, position, Qt::NoModifier);
  drag.added = true;
  drag.restored = before;
  drag.gestureId = id;
  begin(drag);
}

void TransferFunctionCanvas::begin(const CurveDrag& drag) {
  m_drag = drag;
  m_hoveredValue.reset();
  update();
}

void TransferFunctionCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (isDragging())
    continueDrag(*event);
  else
    hover(event->position());
}

void TransferFunctionCanvas::continueDrag(const QMouseEvent& event) {
  const PlotTransform plot = transform();
  const QPointF last = m_drag.last;
  travel(m_drag, event.position(),
         m_drag.kind == CurveDrag::Kind::points && event.modifiers() & Qt::AltModifier);
  if (!m_drag.started)
    return;
  if (m_drag.kind == CurveDrag::Kind::pan)
    return setShown(m_visible, pannedBy(plot, last.x() - event.position().x(), fullRange(m_plot)));
  if (m_drag.kind == CurveDrag::Kind::band) {
    selectPoints(bandedPoints(m_drag, plot, m_plot.function));
    return update();
  }
  const TransferFunction now =
      limitedTo(m_plot.subject, draggedFunction(m_drag, plot, event.modifiers() & Qt::ShiftModifier));
  edit(now, {m_drag.gestureId, dragText(m_drag, now, m_plot.unit, shownDecimals())});
}

void TransferFunctionCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton && !isDragging())
    return openCurveMenu(*this, event->position());
  const CurveHit hit = hitAt(transform(), m_plot.function, event->position());
  const bool middleClick =
      event->button() == Qt::MiddleButton && m_drag.kind == CurveDrag::Kind::pan && !m_drag.started;
  endDrag();
  if (middleClick && hit.part == CurveHit::Part::point) {
    selectPoints({hit.index});
    apply(withoutSelected(m_plot, shownDecimals()));
  }
  hover(event->position());
}

void TransferFunctionCanvas::endDrag() {
  const CurveDrag ended = std::exchange(m_drag, {});
  if (!ended.started && ended.kind == CurveDrag::Kind::band)
    selectPoints(ended.selectedBefore);
  if (!ended.started && ended.kind == CurveDrag::Kind::points) {
    m_inHandBefore = ended.moved;
    selectPoints({ended.grabbed});
  }
  update();
}

void TransferFunctionCanvas::cancelDrag() {
  const CurveDrag cancelled = std::exchange(m_drag, {});
  edit(cancelled.restored,
       {cancelled.gestureId, dragText(cancelled, m_plot.function, m_plot.unit, shownDecimals())});
  update();
}

void TransferFunctionCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  const PlotTransform plot = transform();
  const CurveHit hit = hitAt(plot, m_plot.function, event->position());
  if (hit.part == CurveHit::Part::point) {
    // Its first click has taken one point of several.
    if (contains(m_inHandBefore, hit.index))
      selectPoints(m_inHandBefore);
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
  const double value = roundedToPixel(plot, valueAtX(plot, position.x()));
  apply(withPointAt(m_plot, value, opacityAtY(plot, position.y()), shownDecimals()));
}

void TransferFunctionCanvas::wheelEvent(QWheelEvent* event) {
  if (isDragging())
    return;
  setShown(m_visible, wheeledView(transform(), *event, fullRange(m_plot)));
  hover(event->position());
  event->accept();
}

void TransferFunctionCanvas::hover(const QPointF& position) {
  const PlotTransform plot = transform();
  m_hovered = hitAt(plot, m_plot.function, position);
  setCursor(m_spaceHeld ? Qt::OpenHandCursor : cursorFor(m_hovered.part));
  setHoveredValue(plot.plot.contains(position) ? std::optional(valueAtX(plot, position.x())) : std::nullopt);
}

void TransferFunctionCanvas::leaveEvent(QEvent*) {
  forgetPointer();
}

void TransferFunctionCanvas::forgetPointer() {
  m_hovered = {};
  setHoveredValue(std::nullopt);
}

void TransferFunctionCanvas::setHoveredValue(std::optional<double> value) {
  update();
  if (std::exchange(m_hoveredValue, value) != value)
    emit valueHovered(value);
}

void TransferFunctionCanvas::contextMenuEvent(QContextMenuEvent* event) {
  // The mouse opens the menu on release, on every platform alike; here only the menu key counts.
  if (event->reason() != QContextMenuEvent::Keyboard)
    return;
  const PointIndices& selected = m_plot.selected;
  const QPointF place = selected.empty() ? transform().plot.center()
                                         : positionOf(transform(), m_plot.function.points[selected.front()]);
  openCurveMenu(*this, place);
}

bool TransferFunctionCanvas::isOwnKey(const QKeyEvent& event) const {
  if (!(event.modifiers() & Qt::ControlModifier)) {
    if (event.key() == Qt::Key_Space) // elsewhere it belongs to the picture
      return underMouse();
    if (event.key() == Qt::Key_Escape && isDragging())
      return true;
  }
  return comesBeforeShortcuts(event, !m_plot.selected.empty());
}

bool TransferFunctionCanvas::event(QEvent* event) {
  // While the plot has the focus its keys come before the window's shortcuts.
  if (event->type() == QEvent::ShortcutOverride && isOwnKey(static_cast<QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

bool TransferFunctionCanvas::focusNextPrevChild(bool next) {
  const auto point = pointAfter(m_plot.selected, m_plot.function.points.size(), next);
  if (!point)
    return QWidget::focusNextPrevChild(next);
  takeInHand(*point);
  return true;
}

void TransferFunctionCanvas::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  tellPointFocusSoon(*this);
}

void TransferFunctionCanvas::focusOutEvent(QFocusEvent* event) {
  m_spaceHeld = false; // its release goes elsewhere
  QWidget::focusOutEvent(event);
}

void TransferFunctionCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isDragging())
    return cancelDrag();
  if (event->key() == Qt::Key_Space) {
    m_spaceHeld = true;
    return setCursor(Qt::OpenHandCursor);
  }
  if (isDragging())
    return; // a drag owns the curve until it ends
  if (const auto view = keyedView(transform(), *event, m_plot))
    return setShown(m_visible, *view);
  const CurveKey key = curveKeyOf(*event, !m_plot.selected.empty());
  if (key == CurveKey::none)
    return QWidget::keyPressEvent(event);
  doKey(key, *event);
  revealSelected();
}

void TransferFunctionCanvas::doKey(CurveKey key, const QKeyEvent& event) {
  switch (key) {
  case CurveKey::selectAll:
    return selectPoints(allPoints(m_plot.function));
  case CurveKey::selectNone:
    return selectPoints({});
  case CurveKey::deleteSelected:
    return apply(withoutSelected(m_plot, shownDecimals()));
  case CurveKey::addPoint:
    return apply(withPointBeside(m_plot, m_visible, shownDecimals()));
  case CurveKey::typeNumbers:
    return emit numbersRequested();
  case CurveKey::nudge:
    return nudge(event);
  case CurveKey::none:
    return;
  }
}

void TransferFunctionCanvas::nudge(const QKeyEvent& event) {
  // Keys are one gesture like a drag, until another point is in hand or something else has changed the curve.
  const QPointF arrow = arrowOf(event);
  const bool isAcross = arrow.x() != 0.0;
  const bool goesOn = m_nudged.gestureId != 0 && isAcross == m_nudged.isAcross &&
                      m_plot.function == m_nudged.function && m_plot.selected == m_nudged.selected;
  const std::uint64_t gesture = goesOn ? m_nudged.gestureId : nextGestureId();
  apply(nudged(m_plot, arrow.x(), arrow.y(), shownDecimals()), gesture);
  m_nudged = {gesture, isAcross, m_plot.function, m_plot.selected};
}

void TransferFunctionCanvas::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space || event->isAutoRepeat())
    return QWidget::keyReleaseEvent(event);
  m_spaceHeld = false;
  setCursor(Qt::ArrowCursor);
}

} // namespace limn
