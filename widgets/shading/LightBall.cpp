// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/shading/LightBall.h"

#include "widgets/controls/LabelledRow.h"
#include "widgets/theme/Theme.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double lampRadius = 6.0;
constexpr double marginAround = lampRadius + 2.0; // a lamp on the rim is seen whole
constexpr double stepDeg = 5.0;                   // of an arrow key
constexpr std::uint64_t longestPauseMs = 1000;    // between presses that are one edit

// Turned about an axis of the view: 0 rightwards, 1 upwards.
glm::dvec3 turnedAbout(const glm::dvec3& place, int axis, double degrees) {
  const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
  return axis == 0 ? glm::dvec3(place.x, c * place.y - s * place.z, s * place.y + c * place.z)
                   : glm::dvec3(c * place.x + s * place.z, place.y, -s * place.x + c * place.z);
}

} // namespace

LightBall::LightBall(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setAccessibleName(tr("Lamp"));
  setUnavailable({});
}

void LightBall::setPlace(const glm::dvec3& place) {
  m_place = place;
  update();
}

void LightBall::setAmbient(double share) {
  m_ambient = std::clamp(share, 0.0, 1.0);
  update();
}

void LightBall::setUnavailable(const QString& reason) {
  setEnabled(reason.isEmpty());
  setCursor(reason.isEmpty() ? Qt::PointingHandCursor : Qt::ArrowCursor);
  setToolTip(reason.isEmpty()
                 ? tr("<p>Drag the lamp to where light is to come from; arrow keys move it, too.</p>"
                      "<p>Double click puts it before the viewer.</p>")
                 : reason);
}

QRectF LightBall::ballRect() const {
  const double side = std::min(width(), height()) - 2.0 * marginAround;
  return {0.5 * (width() - side), 0.5 * (height() - side), side, side};
}

// A dull ball, lit as DEFINITION section 4 lights a sample.
QImage LightBall::ballImage(const QSize& pixels) const {
  QImage image(pixels, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  const double radius = 0.5 * pixels.width();
  const glm::dvec3 color(0.86, 0.84, 0.8);
  for (int y = 0; y < pixels.height(); ++y)
    for (int x = 0; x < pixels.width(); ++x) {
      const glm::dvec2 at((x + 0.5) / radius - 1.0, 1.0 - (y + 0.5) / radius);
      const double squared = glm::dot(at, at);
      const double covered = std::clamp((1.0 - std::sqrt(squared)) * radius + 0.5, 0.0, 1.0);
      if (covered == 0.0)
        continue;
      const glm::dvec3 normal(at, std::sqrt(std::max(0.0, 1.0 - squared)));
      const double light = m_ambient + (1.0 - m_ambient) * std::max(0.0, glm::dot(normal, m_place));
      const glm::dvec3 shown = 255.0 * covered * light * color;
      image.setPixel(x, y,
                     qRgba(static_cast<int>(shown.r), static_cast<int>(shown.g), static_cast<int>(shown.b),
                           static_cast<int>(255.0 * covered)));
    }
  return image;
}

void LightBall::paintEvent(QPaintEvent*) {
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(isEnabled() ? 1.0 : 0.35);
  const QRectF ball = ballRect();
  painter.drawImage(ball, ballImage((ball.size() * devicePixelRatioF()).toSize()));
  if (hasFocus()) {
    painter.setPen(QPen(colors.accent, 2.0));
    painter.drawEllipse(ball.adjusted(-3.0, -3.0, 3.0, 3.0));
  }
  // Of a lamp behind the ball there is a ring alone.
  const QPointF lamp = ball.center() + 0.5 * ball.width() * QPointF(m_place.x, -m_place.y);
  painter.setPen(QPen(QColor(30, 30, 30), 1.5));
  painter.setBrush(m_place.z >= 0.0 ? QColor(255, 220, 110) : QColor(Qt::transparent));
  painter.drawEllipse(lamp, lampRadius, lampRadius);
  if (m_place.z < 0.0) {
    painter.setPen(QPen(QColor(255, 220, 110), 1.5));
    painter.drawEllipse(lamp, lampRadius - 1.5, lampRadius - 1.5);
  }
}

void LightBall::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  m_gestureId = nextGestureId();
  moveTo(event->position());
}

void LightBall::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    moveTo(event->position());
}

void LightBall::mouseDoubleClickEvent(QMouseEvent*) {
  edit({0.0, 0.0, 1.0}, m_gestureId);
}

// Beside the ball the lamp goes along its rim.
void LightBall::moveTo(const QPointF& position) {
  const QRectF ball = ballRect();
  const QPointF from = (position - ball.center()) / (0.5 * ball.width());
  glm::dvec2 at(from.x(), -from.y());
  const double length = glm::length(at);
  if (length > 1.0)
    at /= length;
  edit({at, std::sqrt(std::max(0.0, 1.0 - glm::dot(at, at)))}, m_gestureId);
}

void LightBall::keyPressEvent(QKeyEvent* event) {
  const auto turn = [&](int axis, double degrees) {
    // Presses one after another are one step back.
    if (event->timestamp() > m_lastKeyMs + longestPauseMs)
      m_gestureId = nextGestureId();
    m_lastKeyMs = event->timestamp();
    edit(glm::normalize(turnedAbout(m_place, axis, degrees)), m_gestureId);
  };
  switch (event->key()) {
  case Qt::Key_Left:
    return turn(1, -stepDeg);
  case Qt::Key_Right:
    return turn(1, stepDeg);
  case Qt::Key_Up:
    return turn(0, -stepDeg);
  case Qt::Key_Down:
    return turn(0, stepDeg);
  default:
    QWidget::keyPressEvent(event);
  }
}

void LightBall::edit(const glm::dvec3& place, std::uint64_t gestureId) {
  setPlace(place);
  emit placeEdited(place, {gestureId, tr("move the lamp")});
}

} // namespace limn
