// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/LegendPainting.h"

#include "widgets/ValueText.h"
#include "widgets/controls/color/ColorConversion.h"
#include "widgets/curve/plot/CurveGeometry.h"

#include <QFontMetricsF>
#include <QImage>
#include <QObject>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

/// Where the parts of a legend stand.
struct LegendParts {
  PlotTransform transform;
  QRectF bar;       ///< of colours
  double line = 1;  ///< the width of a thin line
  double text = 10; ///< the height of the font
};

LegendParts partsOf(const QRectF& place, const Scene& scene, const QFont& font) {
  const double text = font.pixelSize();
  const QFontMetricsF metrics(font);
  const double left = 2.0 * metrics.height() + metrics.horizontalAdvance(QStringLiteral("0.5"));
  const double ticks = 1.5 * text;
  const double bar = 0.8 * text;
  LegendParts parts;
  parts.text = text;
  parts.line = std::max(1.0, text / 14.0);
  parts.bar = QRectF(place.left() + left, place.bottom() - ticks - bar, place.width() - left - text, bar);
  parts.transform.plot =
      QRectF(QPointF(parts.bar.left(), place.top() + 0.5 * text), QPointF(parts.bar.right(), parts.bar.top()))
          .adjusted(0.0, 0.0, 0.0, -0.25 * text);
  parts.transform.visible = legendRange(scene);
  return parts;
}

// One pixel row of the colours over the axis.
QImage colorsOver(const LegendParts& parts, const TransferFunction& function) {
  const int columns = std::max(1, static_cast<int>(std::ceil(parts.bar.width())));
  QImage row(columns, 1, QImage::Format_RGB32);
  for (int i = 0; i < columns; ++i) {
    const double x = parts.bar.left() + (i + 0.5) * parts.bar.width() / columns;
    row.setPixelColor(i, 0, toQColor(classify(function, valueAtX(parts.transform, x)).color));
  }
  return row;
}

void paintOpacities(QPainter& painter, const LegendParts& parts, const FigureColors& colors) {
  const QRectF& plot = parts.transform.plot;
  for (const double opacity : {0.0, 0.5, 1.0}) {
    const double y = yOfOpacity(parts.transform, opacity);
    painter.setPen(QPen(colors.grid, parts.line));
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.setPen(colors.quiet);
    painter.drawText(
        QRectF(plot.left() - 10.0 * parts.text, y - parts.text, 9.6 * parts.text, 2 * parts.text),
        Qt::AlignRight | Qt::AlignVCenter, plainNumber(opacity, 1));
  }
  painter.save();
  const double width = QFontMetricsF(painter.font()).horizontalAdvance(QStringLiteral("0.5"));
  painter.translate(plot.left() - width - 1.2 * parts.text, plot.center().y());
  painter.rotate(-90.0);
  painter.setPen(colors.quiet);
  painter.drawText(QRectF(-8.0 * parts.text, -parts.text, 16.0 * parts.text, 2.0 * parts.text),
                   Qt::AlignCenter, QObject::tr("Opacity"));
  painter.restore();
}

void paintValues(QPainter& painter, const LegendParts& parts, const Scene& scene,
                 const FigureColors& colors) {
  const QString& told = QString::fromStdString(scene.volume->info().unit);
  const QString unit = told.isEmpty() ? QObject::tr("value") : told;
  const QFontMetricsF metrics(painter.font());
  const double top = parts.bar.bottom() + 0.3 * parts.text;
  const double unitLeft = parts.bar.right() - metrics.horizontalAdvance(unit);
  const QRectF row(parts.bar.left(), top, parts.bar.width(), 1.3 * parts.text);
  painter.setPen(colors.text);
  painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, unit);
  const int most = std::max(2, static_cast<int>(parts.bar.width() / (6.0 * parts.text)));
  const AxisTicks ticks = niceTicks(parts.transform.visible, most);
  for (const double value : ticks.values) {
    const double x = xOfValue(parts.transform, value);
    painter.setPen(QPen(colors.line, parts.line));
    painter.drawLine(QPointF(x, parts.bar.bottom()), QPointF(x, parts.bar.bottom() + 0.25 * parts.text));
    const QString text = valueText(value, {}, decimalsFor(ticks.step));
    const double half = metrics.horizontalAdvance(text) / 2.0;
    if (x + half > unitLeft - 0.6 * parts.text)
      continue;
    painter.setPen(colors.text);
    painter.drawText(QRectF(x - half - parts.text, top, 2.0 * (half + parts.text), row.height()),
                     Qt::AlignCenter, text);
  }
}

void paintOpacityCurve(QPainter& painter, const LegendParts& parts, const TransferFunction& function,
                       const FigureColors& colors, const QImage& row) {
  const QPolygonF line = curvePolygon(parts.transform, function);
  if (line.isEmpty())
    return;
  const QRectF& plot = parts.transform.plot;
  QPolygonF area = line;
  area << plot.bottomRight() << plot.bottomLeft();
  QBrush under(row);
  under.setTransform(QTransform::fromTranslate(plot.left(), 0.0).scale(parts.bar.width() / row.width(), 1.0));
  painter.setPen(Qt::NoPen);
  painter.setBrush(under);
  painter.setOpacity(0.45);
  painter.drawPolygon(area);
  painter.setOpacity(1.0);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.text, 1.6 * parts.line, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPolyline(line);
}

// A picture of a surface hangs on one value.
void paintIsovalue(QPainter& painter, const LegendParts& parts, const Scene& scene,
                   const FigureColors& colors) {
  if (scene.projection != Projection::isosurface && scene.projection != Projection::compositeIsosurface)
    return;
  const double x = xOfValue(parts.transform, scene.isovalue);
  const QRectF& plot = parts.transform.plot;
  if (x < plot.left() || x > plot.right())
    return;
  painter.setPen(QPen(colors.text, parts.line, Qt::DashLine));
  painter.drawLine(QPointF(x, plot.top()), QPointF(x, parts.bar.bottom()));
}

} // namespace

ValueRange legendRange(const Scene& scene) {
  const auto& points = scene.transferFunction.points;
  if (points.empty() || !(points.back().value > points.front().value))
    return scene.volume->range().lowest < scene.volume->range().highest
               ? scene.volume->range()
               : ValueRange{scene.volume->range().lowest - 0.5, scene.volume->range().lowest + 0.5};
  const double room = 0.06 * (points.back().value - points.front().value);
  return {points.front().value - room, points.back().value + room};
}

void paintLegend(QPainter& painter, const QRectF& place, const Scene& scene, const QFont& font,
                 const FigureColors& colors) {
  const LegendParts parts = partsOf(place, scene, font);
  if (parts.bar.width() < 4.0 * parts.text)
    return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font);
  paintOpacities(painter, parts, colors);
  const QImage row = colorsOver(parts, scene.transferFunction);
  paintOpacityCurve(painter, parts, scene.transferFunction, colors, row);
  painter.drawImage(parts.bar, row);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.line, parts.line));
  painter.drawRect(parts.bar);
  paintValues(painter, parts, scene, colors);
  paintIsovalue(painter, parts, scene, colors);
  painter.restore();
}

} // namespace limn
