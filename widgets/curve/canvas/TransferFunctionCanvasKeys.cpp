// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QKeyEvent>

#include <algorithm>

namespace limn {
namespace {

constexpr double opacityStep = 0.01;

double keyFactor(Qt::KeyboardModifiers modifiers) {
  return (modifiers & Qt::ShiftModifier ? 10.0 : 1.0) * (modifiers & Qt::AltModifier ? 0.1 : 1.0);
}

QPointF arrowOf(int key) {
  switch (key) {
  case Qt::Key_Left:
    return {-1.0, 0.0};
  case Qt::Key_Right:
    return {1.0, 0.0};
  case Qt::Key_Up:
    return {0.0, 1.0};
  case Qt::Key_Down:
    return {0.0, -1.0};
  default:
    return {};
  }
}

} // namespace

bool TransferFunctionCanvas::isOwnKey(const QKeyEvent& event) const {
  if (event.modifiers() & Qt::ControlModifier)
    return event.key() == Qt::Key_A || event.key() == Qt::Key_D;
  switch (event.key()) {
  case Qt::Key_Left:
  case Qt::Key_Right:
  case Qt::Key_Up:
  case Qt::Key_Down:
  case Qt::Key_Delete:
  case Qt::Key_Backspace:
  case Qt::Key_Return:
  case Qt::Key_Enter:
    return !m_selected.empty();
  case Qt::Key_Space: // elsewhere it belongs to the picture
    return underMouse();
  case Qt::Key_Escape:
    return m_drag.kind != CurveDrag::Kind::none || !m_selected.empty();
  default:
    return false;
  }
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
  const std::size_t count = m_function.points.size();
  if (count > 0 && m_selected.empty()) {
    selectPoints({next ? 0 : count - 1});
    return true;
  }
  // Past the last point the focus goes on, so that nobody is caught here.
  if (next && count > 0 && m_selected.back() + 1 < count) {
    selectPoints({m_selected.back() + 1});
    return true;
  }
  if (!next && count > 0 && m_selected.front() > 0) {
    selectPoints({m_selected.front() - 1});
    return true;
  }
  return QWidget::focusNextPrevChild(next);
}

void TransferFunctionCanvas::focusOutEvent(QFocusEvent* event) {
  m_spaceHeld = false; // its release goes elsewhere
  QWidget::focusOutEvent(event);
}

void TransferFunctionCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && m_drag.kind != CurveDrag::Kind::none)
    return cancelDrag();
  if (event->key() == Qt::Key_Space) {
    m_spaceHeld = true;
    return setCursor(Qt::OpenHandCursor);
  }
  // A drag owns the curve until it ends.
  if (m_drag.kind != CurveDrag::Kind::none || selectionKey(*event) || nudgeKey(*event))
    return;
  QWidget::keyPressEvent(event);
}

void TransferFunctionCanvas::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space || event->isAutoRepeat())
    return QWidget::keyReleaseEvent(event);
  m_spaceHeld = false;
  setCursor(Qt::ArrowCursor);
}

bool TransferFunctionCanvas::selectionKey(const QKeyEvent& event) {
  const bool control = event.modifiers() & Qt::ControlModifier;
  if (control && event.key() == Qt::Key_A)
    selectAll();
  else if ((control && event.key() == Qt::Key_D) || (event.key() == Qt::Key_Escape && !m_selected.empty()))
    selectPoints({});
  else if (control)
    return false;
  else if ((event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace) && !m_selected.empty())
    deleteSelected();
  else if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
    emit numbersRequested();
  else
    return false;
  return true;
}

bool TransferFunctionCanvas::nudgeKey(const QKeyEvent& event) {
  const QPointF arrow = arrowOf(event.key()) * keyFactor(event.modifiers());
  if (arrow.isNull() || m_selected.empty())
    return false;
  // A key held down is one gesture.
  if (!event.isAutoRepeat())
    m_keyGestureId = nextGestureId();
  const TransferFunction moved = limitedTo(
      m_subject, withPointsMoved(m_function, m_selected, arrow.x() * valueUnit(), arrow.y() * opacityStep));
  const QString text = m_selected.size() > 1
                           ? tr("move %1 points").arg(m_selected.size())
                           : tr("move point to %1").arg(textOf(moved.points[m_selected.front()].value));
  edit(moved, {m_keyGestureId, text});
  return true;
}

} // namespace limn
