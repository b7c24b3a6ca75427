// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/chart/ChartNotes.h"

#include "widgets/ValueText.h"
#include "widgets/accuracy/chart/AccuracyChart.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <optional>

namespace limn {

ChartNotes::ChartNotes(AccuracyChart& chart) : QGraphicsItem(&chart), m_chart(chart) {
  setZValue(100.0);
  setAcceptedMouseButtons(Qt::NoButton);
}

QRectF ChartNotes::boundingRect() const {
  return m_chart.rect();
}

void ChartNotes::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setFont(m_chart.textFont(0.92));
  paintLegendBelow(*painter);
  painter->setClipRect(m_chart.plotArea());
  if (m_chart.curves().empty()) {
    paintEmpty(*painter);
  } else {
    if (m_chart.m_measure == ErrorMeasure::p99_9)
      paintOneLevel(*painter);
    for (std::size_t i = 0; i < m_chart.curves().size(); ++i)
      for (const ChartMark& mark : m_chart.curves()[i].marks) {
        const QColor color = curveLook(m_chart.m_style, static_cast<int>(i)).color;
        paintSpread(*painter, mark, color);
        if (mark.isBelowFloor)
          paintFloor(*painter, mark, color);
      }
    paintChosen(*painter);
  }
  painter->restore();
}

void ChartNotes::paintLegendBelow(QPainter& painter) const {
  const QRectF place = m_chart.legendRect();
  if (place.isEmpty())
    return;
  painter.setFont(m_chart.legend()->font());
  const std::vector<LegendEntry> entries = m_chart.legendEntries();
  paintLegend(painter, entries, legendLayout(entries, painter.font(), place.width()), place.topLeft(),
              chartColors(m_chart.m_style).text);
  painter.setFont(m_chart.textFont(0.92));
}

void ChartNotes::paintEmpty(QPainter& painter) const {
  painter.setPen(chartColors(m_chart.m_style).secondaryText);
  const QString why = m_chart.report().points.empty()
                          ? AccuracyChart::tr("Nothing is measured yet.")
                          : AccuracyChart::tr("Not converged: the exact picture still changes with finer "
                                              "steps, so no error is known.");
  const double margin = m_chart.m_textSize;
  painter.drawText(m_chart.plotArea().adjusted(margin, margin, -margin, -margin),
                   Qt::AlignCenter | Qt::TextWordWrap, why);
}

// The label stands where it covers no curve, as far to the right as possible; where there is no such place, a
// shorter one does.
void ChartNotes::paintOneLevel(QPainter& painter) const {
  const QRectF plot = m_chart.plotArea();
  const double y = m_chart.positionAt(1.0, 1.0).y();
  painter.setPen(QPen(chartColors(m_chart.m_style).text, 1.0, Qt::DashLine));
  painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
  const QFontMetricsF metrics(painter.font());
  for (const QString& text :
       {AccuracyChart::tr("1 level: accurate to the screen"), AccuracyChart::tr("1 level")}) {
    const QSizeF size(metrics.horizontalAdvance(text) + 4.0, metrics.height());
    const std::optional<QPointF> corner = freeCorner(size, y);
    if (!corner)
      continue;
    painter.drawText(QRectF(*corner, size), Qt::AlignCenter, text);
    break;
  }
}

// Where a label of this size can stand above or below the line at `y`.
std::optional<QPointF> ChartNotes::freeCorner(const QSizeF& size, double y) const {
  const QRectF plot = m_chart.plotArea();
  const double step = 0.5 * m_chart.m_textSize;
  for (double x = plot.right() - size.width() - 6.0; x > plot.left() + 6.0; x -= step)
    for (const double top : {y - size.height() - 2.0, y + 2.0})
      if (isFree(QRectF(QPointF(x, top), size)))
        return QPointF(x, top);
  return std::nullopt;
}

bool ChartNotes::isFree(const QRectF& place) const {
  const double radius = m_chart.m_textSize;
  const QRectF around = place.adjusted(-0.6 * radius, -0.2 * radius, 0.6 * radius, 0.2 * radius);
  for (const ChartCurve& curve : m_chart.curves())
    for (std::size_t i = 0; i < curve.marks.size(); ++i) {
      const ChartMark& next = curve.marks[std::min(i + 1, curve.marks.size() - 1)];
      const QPointF from = m_chart.positionAt(curve.marks[i].ms, curve.marks[i].error);
      const QPointF way = m_chart.positionAt(next.ms, next.error) - from;
      // Places closer together than the label is high do not miss it.
      const double pieces = 1.0 + std::floor(std::hypot(way.x(), way.y()) / (0.5 * radius));
      for (double piece = 0.0; piece <= pieces; ++piece)
        if (around.contains(from + piece / pieces * way))
          return false;
    }
  return true;
}

// A whisker from the least to the most time, where it reaches beyond the mark.
void ChartNotes::paintSpread(QPainter& painter, const ChartMark& mark, const QColor& color) const {
  const QPointF middle = m_chart.positionAt(mark.ms, mark.error);
  const double left = m_chart.positionAt(mark.leastMs, mark.error).x();
  const double right = m_chart.positionAt(mark.mostMs, mark.error).x();
  const double radius = 0.45 * m_chart.m_textSize;
  const double cap = 0.25 * m_chart.m_textSize;
  painter.setPen(QPen(color, 0.08 * m_chart.m_textSize));
  for (const double end : {left, right}) {
    const double direction = end < middle.x() ? -1.0 : 1.0;
    if (direction * (end - middle.x()) <= radius)
      continue;
    painter.drawLine(QPointF(middle.x() + direction * radius, middle.y()), QPointF(end, middle.y()));
    painter.drawLine(QPointF(end, middle.y() - cap), QPointF(end, middle.y() + cap));
  }
}

// An arrow and what the error is known to be below, to its left where it would leave the plot.
void ChartNotes::paintFloor(QPainter& painter, const ChartMark& mark, const QColor& color) const {
  const double unit = m_chart.m_textSize;
  const QPointF top = m_chart.positionAt(mark.ms, mark.error) + QPointF(0.0, 0.5 * unit);
  const QPointF tip = top + QPointF(0.0, 0.7 * unit);
  painter.setPen(QPen(color, 0.1 * unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawLine(top, tip);
  painter.drawPolyline(QPolygonF{tip + QPointF(-0.22, -0.25) * unit, tip, tip + QPointF(0.22, -0.25) * unit});
  painter.setPen(chartColors(m_chart.m_style).secondaryText);
  const QString bound = AccuracyChart::tr("< %1").arg(digitsNumber(mark.error, 2));
  const double width = QFontMetricsF(painter.font()).horizontalAdvance(bound);
  const bool fitsRight = tip.x() + 0.6 * unit + width <= m_chart.plotArea().right();
  painter.drawText(tip + QPointF(fitsRight ? 0.6 * unit : -0.6 * unit - width, 0.2 * unit), bound);
}

void ChartNotes::paintChosen(QPainter& painter) const {
  QColor accent = chartColors(m_chart.m_style).accent;
  const auto ring = [&](std::optional<std::size_t> point, double radius, double filling) {
    const std::optional<QPointF> place = point ? m_chart.positionOf(*point) : std::nullopt;
    if (!place)
      return;
    accent.setAlphaF(1.0f);
    painter.setPen(QPen(accent, 2.0));
    accent.setAlphaF(static_cast<float>(filling));
    painter.setBrush(accent);
    painter.drawEllipse(*place, radius, radius);
  };
  ring(m_chart.m_current, m_chart.m_textSize, 0.25);
  ring(m_chart.m_hovered, 0.8 * m_chart.m_textSize, 0.0);
}

} // namespace limn
