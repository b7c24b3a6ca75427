// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/MeasureInput.h"

#include "widgets/Gesture.h"
#include "widgets/view/gestures/Probe.h"
#include "widgets/view/gestures/ViewDrag.h"
#include "widgets/view/overlay/Overlay.h"

#include <QMouseEvent>

namespace limn {

std::optional<MeasureHandle> measureHandleUnder(const OverlaySource& source, const QPointF& point) {
  return measureHandleAt(measureShapesOf(source, standingAt(source.geometry, point)), point);
}

MeasureInput::MeasureInput(QObject* parent, Shown shown) : QObject(parent), m_shown(std::move(shown)) {}

void MeasureInput::forget() {
  m_held.reset();
  m_drawn.reset();
}

// Says it with the ray through a point of the view; false, and nothing is said, beside the pictures.
bool MeasureInput::say(Said said, const QPointF& point) {
  const OverlaySource source = m_shown();
  const auto ray = rayUnder(source.geometry, source.comparison.scene.camera, point);
  if (ray)
    emit(this->*said)(*ray, sideAt(source, point));
  return ray.has_value();
}

bool MeasureInput::press(const OverlaySource& source, const QMouseEvent& event, bool isTool) {
  if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier)
    return false;
  return take(source, event.position()) || (isTool && begin(source, event.position()));
}

// Whether the button takes hold of a handle.
bool MeasureInput::take(const OverlaySource& source, const QPointF& point) {
  m_held = measureHandleUnder(source, point);
  if (m_held)
    emit taken(*m_held, nextGestureId());
  return m_held.has_value();
}

// Whether the button begins a measurement that a drag ends; a click gives it one place.
bool MeasureInput::begin(const OverlaySource& source, const QPointF& point) {
  if (isOnWipeBorder(source.geometry, point))
    return false;
  const std::optional<Ray> ray = rayUnder(source.geometry, source.comparison.scene.camera, point);
  if (ray && m_drawsFrom(*ray, sideAt(source, point)))
    m_drawn = Drawn{point};
  return m_drawn.has_value();
}

bool MeasureInput::move(const QPointF& point) {
  if (m_held)
    say(&MeasureInput::led, point);
  else if (m_drawn)
    stretch(point);
  else
    return false;
  return true;
}

void MeasureInput::stretch(const QPointF& point) {
  if (!m_drawn->hasMoved && isClick(m_drawn->from, point))
    return;
  if (!std::exchange(m_drawn->hasMoved, true))
    click(m_drawn->from);
  say(&MeasureInput::stretched, point);
}

bool MeasureInput::release(const QMouseEvent& event) {
  if (!isHolding() || event.button() != Qt::LeftButton)
    return false;
  const std::optional<Drawn> drawn = m_drawn;
  forget();
  if (!drawn)
    return true;
  // A drag that comes back to where it began, or ends beside the pictures, measures nothing.
  const bool isBack = drawn->hasMoved && isClick(drawn->from, event.position());
  if (isBack || !say(&MeasureInput::placeRequested, event.position()))
    emit dropped();
  return true;
}

void MeasureInput::click(const QPointF& point) {
  say(&MeasureInput::placeRequested, point);
}

bool MeasureInput::cancel() {
  if (std::exchange(m_held, std::nullopt))
    emit left();
  else if (m_drawn)
    drop();
  else
    return false;
  return true;
}

void MeasureInput::drop() {
  m_drawn.reset();
  emit dropped();
}

void MeasureInput::remove() {
  m_drawn.reset();
  emit removed();
}

} // namespace limn
