// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/CompareView.h"
#include "widgets/view/SideText.h"
#include "widgets/view/ViewOverlay.h"

#include <QOpenGLPaintDevice>
#include <QPainter>

#include <algorithm>
#include <cmath>

// What stands above the pictures of the compare view.

namespace limn {
namespace {

constexpr double margin = 12.0;

// A value with as many digits as its range makes sensible.
QString valueText(double value, const Volume& volume) {
  const double span = volume.range().highest - volume.range().lowest;
  const int digits = span > 0.0 ? std::clamp(static_cast<int>(3.0 - std::log10(span)), 0, 6) : 0;
  const QString number = QString::number(value, 'f', digits);
  const QString unit = QString::fromStdString(volume.info().unit);
  return unit.isEmpty() ? number : QStringLiteral("%1 %2").arg(number, unit);
}

} // namespace

QRectF CompareView::logicalRect(int position) const {
  const std::vector<PixelRect> places = rects();
  if (position >= static_cast<int>(places.size()))
    return rect();
  const double ratio = devicePixelRatioF();
  const PixelRect& place = places[position];
  return {place.topLeft.x / ratio, place.topLeft.y / ratio, place.size.x / ratio, place.size.y / ratio};
}

SideLabel CompareView::labelOf(int position) const {
  const int side = sideShownAt(position);
  const Scene scene = sceneOfSide(side);
  std::optional<double> ms;
  if (side < static_cast<int>(m_state.sides.size()))
    ms = m_state.sides[side].completeMs;
  SideLabel label;
  label.title = modelName(scene.shading.model);
  label.details = sideDetails(scene, ms);
  label.hovered = position == m_hoveredLabel;
  label.detailsOpacity = label.hovered ? 1.0 : m_labelFade.currentValue().toDouble();
  return label;
}

QRectF CompareView::labelRect(int position) const {
  QRectF side = logicalRect(position);
  const bool over = m_layout == CompareLayout::wipe || m_layout == CompareLayout::difference;
  if (over) // two labels share one picture: each has its half
    position == 0 ? side.setRight(side.center().x()) : side.setLeft(side.center().x());
  return labelPlate(font(), labelOf(position), side, over && position == 1);
}

void CompareView::paintOverlay() {
  // Not on the widget itself: while a window is grabbed, Qt would lead its painters elsewhere.
  const glm::ivec2 size = deviceSize();
  QOpenGLPaintDevice device(size.x, size.y);
  device.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&device);
  painter.setFont(font());
  painter.setRenderHint(QPainter::TextAntialiasing);
  if (m_layout == CompareLayout::sideBySide) {
    const QRectF left = logicalRect(0);
    const QRectF right = logicalRect(1);
    painter.fillRect(QRectF(left.topRight(), right.bottomLeft()), QColor(70, 76, 88));
  }
  paintOrientation(painter);
  paintScale(painter);
  if (m_layout == CompareLayout::wipe)
    paintWipeBorder(painter, m_wipe * width(), rect(), m_wipeHovered || (m_drag && m_drag->wipe));
  for (int position = 0; position < pictureCount(m_layout); ++position)
    paintLabel(painter, labelOf(position), labelRect(position));
  const QPointF corner(width() - margin, height() - margin);
  paintNote(painter, tr("Not for diagnosis"), corner, Qt::AlignRight);
  if (!m_state.limitation.isEmpty())
    paintNote(painter, m_state.limitation, {width() / 2.0, height() - 3 * margin}, Qt::AlignHCenter);
  if (m_probe)
    paintProbe(painter, m_probePoint, valueText(m_probe->value, *m_scene.volume), rect());
  if (!m_state.resting && !m_state.sides.empty()) {
    double fraction = 0.0;
    for (const SideState& side : m_state.sides)
      fraction += side.fraction / m_state.sides.size();
    paintProgress(painter, fraction, rect());
  }
}

void CompareView::paintOrientation(QPainter& painter) {
  const int pictures = m_layout == CompareLayout::sideBySide ? 2 : 1;
  for (int position = 0; position < pictures; ++position) {
    const QRectF side = logicalRect(position);
    double column = side.center().x();
    if (m_layout == CompareLayout::wipe && std::abs(m_wipe * width() - column) < 2 * margin)
      column = m_wipe * width() + 2 * margin; // beside the border, not under it
    const QRectF label = labelRect(position);
    const bool inTheWay = std::abs(column - label.center().x()) < label.width() / 2 + 2 * margin;
    if (m_scene.volume->info().orientationKnown)
      paintLetters(painter, orientationLetters(m_scene.camera), side, column,
                   inTheWay ? label.bottom() + margin / 3 : side.top());
    else
      paintNote(painter, tr("Orientation unknown"), {side.center().x(), side.bottom() - margin},
                Qt::AlignHCenter);
  }
}

void CompareView::paintScale(QPainter& painter) {
  if (!m_scene.volume->info().spacingKnown)
    return;
  const QRectF side = logicalRect(0);
  const ScaleBar bar = scaleBar(mmPerPixel(m_scene.camera, side.height()), std::min(160.0, side.width() / 4));
  if (bar.pixels < 8.0)
    return;
  const QString length = tr("%1 mm").arg(bar.lengthMm);
  // In perspective a length holds at one distance only.
  const bool perspective = m_scene.camera.projection == Camera::Projection::perspective;
  paintScaleBar(painter, bar, perspective ? tr("%1 at the centre").arg(length) : length, side);
}

} // namespace limn
