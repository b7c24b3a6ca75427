// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ray/ProfileChart.h"

#include "widgets/ray/ProfilePicture.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr double chartZoomStep = 1.25;
constexpr double fastPixels = 10.0;

} // namespace

ProfileChart::ProfileChart(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("profileChart"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Value, opacity and share of the light along the ray"));
}

void ProfileChart::setProfile(const std::optional<RayProfile>& profile, const ProfileNames& names,
                              const std::optional<double>& crosshairMm) {
  m_profile = profile;
  m_names = names;
  m_crosshair = crosshairMm;
  if (!m_profile)
    m_cursor.reset();
  else if (m_isZoomed)
    m_visible = {std::min(m_visible.lowest, m_profile->lengthMm / 2.0),
                 std::min(m_visible.highest, m_profile->lengthMm)};
  else
    showAll();
  if (m_cursor)
    m_cursor = std::min(*m_cursor, m_profile->lengthMm);
  update();
  emit cursorMoved();
}

PlotTransform ProfileChart::depths() const {
  return {profilePlot(size()), m_visible};
}

void ProfileChart::showAll() {
  m_isZoomed = false;
  m_visible = whole();
  update();
}

void ProfileChart::zoom(double x, double factor) {
  m_visible = zoomedAtX(depths(), x, factor, whole());
  m_isZoomed = m_visible != whole();
  update();
}

void ProfileChart::readAt(double depthMm) {
  const double depth = std::clamp(depthMm, 0.0, m_profile->lengthMm);
  m_visible = revealed(depths(), depth, 0.0, whole());
  update();
  if (std::exchange(m_cursor, depth) != depth)
    emit cursorMoved();
}

void ProfileChart::paintEvent(QPaintEvent*) {
  if (!m_profile)
    return;
  QPainter painter(this);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.92);
  painter.setFont(small);
  paintProfile(painter, {*m_profile, m_names, depths(), themeColors(palette()), halfLightDepth(*m_profile),
                         m_cursor, m_crosshair});
}

void ProfileChart::mouseMoveEvent(QMouseEvent* event) {
  if (m_profile)
    readAt(valueAtX(depths(), event->position().x()));
}

void ProfileChart::mousePressEvent(QMouseEvent* event) {
  if (!m_profile || event->button() != Qt::LeftButton)
    return;
  readAt(valueAtX(depths(), event->position().x()));
  emit depthChosen(*m_cursor);
}

void ProfileChart::mouseDoubleClickEvent(QMouseEvent* event) {
  if (m_profile && event->button() == Qt::LeftButton)
    showAll();
}

// What the keys read stays.
void ProfileChart::leaveEvent(QEvent*) {
  if (hasFocus() || !std::exchange(m_cursor, std::nullopt))
    return;
  update();
  emit cursorMoved();
}

void ProfileChart::wheelEvent(QWheelEvent* event) {
  if (!m_profile)
    return;
  zoom(event->position().x(), std::pow(chartZoomStep, event->angleDelta().y() / 120.0));
  event->accept();
}

void ProfileChart::keyPressEvent(QKeyEvent* event) {
  const bool isPlain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  if (!m_profile || !isPlain || !obey(event->key(), event->modifiers() & Qt::ShiftModifier))
    QWidget::keyPressEvent(event);
}

bool ProfileChart::obey(int key, bool isFast) {
  const std::optional<double> half = halfLightDepth(*m_profile);
  const double now = m_cursor.value_or(half.value_or(m_profile->lengthMm / 2.0));
  const double step = valuePerPixel(depths()) * (isFast ? fastPixels : 1.0);
  switch (key) {
  case Qt::Key_Left:
    readAt(now - step);
    return true;
  case Qt::Key_Right:
    readAt(now + step);
    return true;
  case Qt::Key_Home:
    readAt(0.0);
    return true;
  case Qt::Key_End:
    readAt(m_profile->lengthMm);
    return true;
  case Qt::Key_H:
    if (half)
      readAt(*half);
    return true;
  case Qt::Key_Return:
  case Qt::Key_Enter:
    readAt(now);
    emit depthChosen(now);
    return true;
  case Qt::Key_Plus:
  case Qt::Key_Equal:
    zoom(xOfValue(depths(), now), chartZoomStep);
    return true;
  case Qt::Key_Minus:
    zoom(xOfValue(depths(), now), 1.0 / chartZoomStep);
    return true;
  case Qt::Key_F:
    showAll();
    return true;
  default:
    return false;
  }
}

} // namespace limn
