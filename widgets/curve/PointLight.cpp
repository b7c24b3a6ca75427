// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/PointLight.h"

#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include <QMouseEvent>

#include <utility>

namespace limn {
namespace {

// So long the pointer rests on a point before pictures change: on its way across it changes nothing.
constexpr int restBeforeLightMs = 150;

} // namespace

PointLight::PointLight(TransferFunctionCanvas& canvas) : QObject(&canvas), m_canvas(canvas) {
  canvas.installEventFilter(this);
  m_rest.setSingleShot(true);
  m_rest.setInterval(restBeforeLightMs);
  connect(&m_rest, &QTimer::timeout, this, [this] { light(m_waiting); });
  connect(&canvas, &TransferFunctionCanvas::transferFunctionEdited, this, &PointLight::turnOff);
}

void PointLight::turnOff() {
  m_isByKey = false;
  wait(std::nullopt);
}

void PointLight::wait(std::optional<std::size_t> point) {
  if (std::exchange(m_waiting, point) == point && m_lit == point)
    return;
  m_rest.stop();
  if (point && point != m_lit)
    m_rest.start();
  else
    light(point);
}

void PointLight::light(std::optional<std::size_t> point) {
  const bool isThere = !point || *point < m_canvas.transferFunction().points.size();
  const std::optional<std::size_t> lit = isThere ? point : std::nullopt;
  if (std::exchange(m_lit, lit) != lit)
    emit changed(lit);
}

bool PointLight::toggle() {
  const std::optional<std::size_t> focused = m_canvas.focusedPoint();
  if (!focused)
    return false;
  const bool isOff = m_lit == focused;
  m_rest.stop();
  m_isByKey = !isOff;
  m_waiting = isOff ? std::nullopt : focused;
  light(m_waiting);
  return true;
}

bool PointLight::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
  case QEvent::MouseMove: {
    const auto& move = static_cast<const QMouseEvent&>(*event);
    if (move.buttons() != Qt::NoButton) {
      turnOff();
      break;
    }
    const CurveHit hit = hitAt(m_canvas.transform(), m_canvas.transferFunction(), move.position());
    if (hit.part == CurveHit::Part::point)
      m_isByKey = false;
    if (!m_isByKey) // what a key lit stays until the pointer is on another point
      wait(hit.part == CurveHit::Part::point ? std::optional(hit.index) : std::nullopt);
    break;
  }
  case QEvent::MouseButtonPress:
  case QEvent::Wheel:
  case QEvent::Leave:
  case QEvent::FocusOut:
  case QEvent::Hide:
  case QEvent::WindowDeactivate:
    turnOff();
    break;
  case QEvent::KeyPress: {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (key.key() == Qt::Key_H && key.modifiers() == Qt::NoModifier)
      return toggle();
    turnOff();
    break;
  }
  default:
    break;
  }
  return QObject::eventFilter(watched, event);
}

} // namespace limn
