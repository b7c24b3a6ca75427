// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/chart/ChartLegend.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Text heights: the room of a mark unless it is larger, and what keeps it from its word and from the next.
constexpr double markRoom = 1.2;
constexpr double wordGap = 0.4;
constexpr double gap = 0.9;
constexpr double rowHeight = 1.4;

// Corners of a regular polygon, the first one on top; `inner` < 1 makes every second one a notch.
QPolygonF polygon(const QPointF& centre, double radius, int corners, double inner = 1.0) {
  QPolygonF shape;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / corners;
    const double r = i % 2 == 1 ? inner * radius : radius;
    shape << centre + QPointF(r * std::sin(angle), -r * std::cos(angle));
  }
  return shape;
}

double roomOf(const LegendEntry& entry, double unit) {
  return std::max(markRoom * unit, entry.size + 2.0); // and its line
}

void paintMark(QPainter& painter, const LegendEntry& entry, const QPointF& centre) {
  painter.setPen(QPen(entry.color, 1.2));
  painter.setBrush(entry.isFilled ? QBrush(entry.color) : QBrush(Qt::NoBrush));
  const double radius = 0.5 * entry.size;
  switch (entry.shape) {
  case QScatterSeries::MarkerShapeRectangle:
    painter.drawRect(QRectF(centre.x() - radius, centre.y() - radius, entry.size, entry.size));
    break;
  case QScatterSeries::MarkerShapeTriangle:
    painter.drawPolygon(polygon(centre, radius, 3));
    break;
  case QScatterSeries::MarkerShapeRotatedRectangle:
    painter.drawPolygon(polygon(centre, radius, 4));
    break;
  case QScatterSeries::MarkerShapePentagon:
    painter.drawPolygon(polygon(centre, radius, 5));
    break;
  case QScatterSeries::MarkerShapeStar:
    painter.drawPolygon(polygon(centre, radius, 10, 0.45));
    break;
  default:
    painter.drawEllipse(centre, radius, radius);
  }
}

} // namespace

LegendLayout legendLayout(const std::vector<LegendEntry>& entries, const QFont& font, double width) {
  const QFontMetricsF metrics(font);
  const double unit = metrics.height();
  LegendLayout layout;
  QPointF next;
  for (const LegendEntry& entry : entries) {
    const double needed = roomOf(entry, unit) + wordGap * unit + metrics.horizontalAdvance(entry.name);
    if (next.x() > 0.0 && next.x() + needed > width)
      next = {0.0, next.y() + rowHeight * unit};
    layout.places.push_back(next);
    next.rx() += needed + gap * unit;
  }
  layout.height = entries.empty() ? 0.0 : next.y() + rowHeight * unit;
  return layout;
}

void paintLegend(QPainter& painter, const std::vector<LegendEntry>& entries, const LegendLayout& layout,
                 const QPointF& corner, const QColor& text) {
  const double unit = QFontMetricsF(painter.font()).height();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const QPointF place = corner + layout.places[i];
    const double room = roomOf(entries[i], unit);
    paintMark(painter, entries[i], place + QPointF(0.5 * room, 0.5 * rowHeight * unit));
    painter.setPen(text);
    painter.drawText(QRectF(place.x() + room + wordGap * unit, place.y(), 1e4, rowHeight * unit),
                     Qt::AlignLeft | Qt::AlignVCenter, entries[i].name);
  }
}

} // namespace limn
