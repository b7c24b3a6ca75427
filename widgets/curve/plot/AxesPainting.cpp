// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/plot/CanvasPicture.h"

#include "widgets/ValueText.h"
#include "widgets/controls/color/ColorConversion.h"

#include <QObject>
#include <QPaintDevice>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double stripHeight = 10.0;
constexpr double stripGap = stripBelow - stripHeight;
constexpr double pixelsPerTick = 90.0;
constexpr double pixelsPerOpacityTick = 24.0;

std::vector<double> opacityTicks(const PlotTransform& transform) {
  if (transform.fineLowOpacities)
    return {0.0, 0.001, 0.01, 0.05, 0.2, 0.5, 1.0};
  if (transform.plot.height() < 4.0 * pixelsPerOpacityTick)
    return {0.0, 0.5, 1.0};
  return {0.0, 0.25, 0.5, 0.75, 1.0};
}

void paintOpacityAxis(QPainter& painter, const CanvasPicture& picture) {
  const QRectF& plot = picture.transform.plot;
  double lastY = 1e9;
  for (const double opacity : opacityTicks(picture.transform)) {
    const double y = std::round(yOfOpacity(picture.transform, opacity)) + 0.5;
    painter.setPen(picture.colors.grid);
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    if (lastY - y < 13.0)
      continue;
    lastY = y;
    painter.setPen(picture.colors.secondaryText);
    painter.drawText(QRectF(0.0, y - 10.0, plot.left() - 6.0, 20.0), Qt::AlignRight | Qt::AlignVCenter,
                     plainNumber(opacity, 3));
  }
  painter.save();
  painter.translate(8.0, plot.center().y());
  painter.rotate(-90.0);
  painter.setPen(picture.colors.secondaryText);
  painter.drawText(QRectF(-60.0, -8.0, 120.0, 16.0), Qt::AlignCenter, QObject::tr("Opacity"));
  painter.restore();
}

QString axisText(const CanvasPicture& picture) {
  if (picture.subject == CurveSubject::value)
    return picture.unit.isEmpty() ? QObject::tr("value") : picture.unit;
  return picture.unit.isEmpty() ? QObject::tr("gradient") : picture.unit;
}

void paintValueAxis(QPainter& painter, const CanvasPicture& picture) {
  const QRectF& plot = picture.transform.plot;
  const double textTop = plot.bottom() + (hasColors(picture.subject) ? stripBelow : 0.0) + 3.0;
  const QString unit = axisText(picture);
  const double unitWidth = painter.fontMetrics().horizontalAdvance(unit) + 12.0;
  painter.setPen(picture.colors.secondaryText);
  painter.drawText(QRectF(plot.right() - unitWidth, textTop, unitWidth, 20.0),
                   Qt::AlignRight | Qt::AlignVCenter, unit);
  const int most = std::max(2, static_cast<int>(plot.width() / pixelsPerTick));
  const AxisTicks ticks = niceTicks(picture.transform.visible, most);
  for (const double value : ticks.values) {
    const double x = std::round(xOfValue(picture.transform, value)) + 0.5;
    const QString text = valueText(value, {}, decimalsFor(ticks.step));
    const double half = painter.fontMetrics().horizontalAdvance(text) / 2.0;
    if (x + half > plot.right() - unitWidth)
      continue; // a line without its number tells nothing
    painter.setPen(picture.colors.grid);
    painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
    painter.setPen(picture.colors.secondaryText);
    painter.drawText(QRectF(x - 60.0, textTop, 120.0, 20.0), Qt::AlignHCenter | Qt::AlignVCenter, text);
  }
}

void paintColorStrip(QPainter& painter, const CanvasPicture& picture) {
  const QRectF& plot = picture.transform.plot;
  const QRectF strip(plot.left(), plot.bottom() + stripGap, plot.width(), stripHeight);
  QPainterPath rounded;
  rounded.addRoundedRect(strip, 3.0, 3.0);
  QPainterPath frame;
  frame.addRoundedRect(strip.adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (picture.function.points.empty()) {
    painter.fillPath(rounded, picture.colors.grid);
  } else {
    painter.setClipPath(rounded);
    painter.drawImage(strip, colorRow(picture, painter.device()->devicePixelRatioF()));
    painter.setClipping(false);
  }
  // White ends in a light window, black ones in a dark.
  painter.setPen(QPen(picture.colors.outline, 1.0));
  painter.drawPath(frame);
  painter.restore();
}

} // namespace

QRectF plotWithin(const QSizeF& size, CurveSubject subject) {
  const double below = ticksBelow + (hasColors(subject) ? stripBelow : 0.0);
  return {plotLeft, plotTop, std::max(20.0, size.width() - plotLeft - plotRight),
          std::max(20.0, size.height() - plotTop - below)};
}

QImage colorRow(const CanvasPicture& picture, double columnsPerPixel) {
  const int columns = std::max(1, static_cast<int>(columnsPerPixel * picture.transform.plot.width()));
  QImage row(columns, 1, QImage::Format_RGB32);
  for (int i = 0; i < columns; ++i) {
    const double value =
        valueAtX(picture.transform, picture.transform.plot.left() + (i + 0.5) / columnsPerPixel);
    row.setPixelColor(i, 0, toQColor(classify(picture.function, value).color));
  }
  return row;
}

void paintAxes(QPainter& painter, const CanvasPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(picture.transform.plot, picture.colors.base);
  if (picture.histogram.area.isNull() && picture.function.points.empty())
    return; // axes of nothing
  paintValueAxis(painter, picture);
  paintOpacityAxis(painter, picture);
  if (hasColors(picture.subject))
    paintColorStrip(painter, picture);
}

} // namespace limn
