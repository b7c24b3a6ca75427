// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/ChartLegend.h"

#include "widgets/theme/Theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

// After Okabe and Ito, "Color Universal Design" (2008): their yellow is too faint on white and gives way to
// ochre; on dark ground the same hues are lighter.
constexpr std::array<const char*, 8> onLight{"#0072b2", "#d55e00", "#00876a", "#b0478c",
                                             "#b98600", "#8a4b2a", "#5b4bb5", "#4d4d4d"};
constexpr std::array<const char*, 8> onDark{"#56b4e9", "#ff8f4d", "#2fc79f", "#e693c6",
                                            "#f0c24b", "#d0a080", "#a99bff", "#c9cdd2"};

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

// Of every mark, so that names in a column begin one below the other.
double roomOfMarks(const std::vector<LegendEntry>& entries, double unit) {
  double room = markRoom * unit;
  for (const LegendEntry& entry : entries)
    room = std::max(room, entry.size + 2.0); // and its line
  return room;
}

} // namespace

ChartColors chartColors(ChartStyle style) {
  if (style == ChartStyle::print)
    return {.background = "#ffffff",
            .text = "#111111",
            .secondaryText = "#444444",
            .grid = "#e4e4e4",
            .border = "#777777",
            .accent = "#1667cc",
            .trade = "#eaeaea"};
  const bool isDark = style == ChartStyle::dark;
  const ThemeColors theme = themeColors(isDark ? Look::dark : Look::light);
  return {.background = theme.window,
          .text = theme.text,
          .secondaryText = theme.secondaryText,
          .grid = isDark ? "#2f3338" : "#e0e3e7",
          .border = theme.border,
          .accent = theme.accent,
          .trade = isDark ? "#30353b" : "#e1e4e9"};
}

CurveLook curveLook(ChartStyle style, int curve) {
  const auto& colors = style == ChartStyle::dark ? onDark : onLight;
  const auto index = static_cast<std::size_t>(curve);
  return {colors[index % colors.size()], static_cast<MarkShape>(curve % 6), index >= colors.size()};
}

void paintMark(QPainter& painter, MarkShape shape, const QPointF& centre, double size) {
  const double radius = 0.5 * size;
  if (shape == MarkShape::circle)
    painter.drawEllipse(centre, radius, radius);
  else if (shape == MarkShape::square)
    painter.drawRect(QRectF(centre.x() - radius, centre.y() - radius, size, size));
  else // pointed, so a little larger to weigh as much
    painter.drawPolygon(shape == MarkShape::triangle
                            ? polygon(centre + QPointF(0.0, 0.1 * size), 1.2 * radius, 3)
                        : shape == MarkShape::diamond  ? polygon(centre, 1.15 * radius, 4)
                        : shape == MarkShape::pentagon ? polygon(centre, 1.1 * radius, 5)
                                                       : polygon(centre, 1.2 * radius, 10, 0.45));
}

LegendLayout legendLayout(const std::vector<LegendEntry>& entries, const QFont& font, double width) {
  const QFontMetricsF metrics(font);
  const double unit = metrics.height();
  const double room = roomOfMarks(entries, unit);
  LegendLayout layout;
  QPointF next;
  for (const LegendEntry& entry : entries) {
    const double needed = room + wordGap * unit + metrics.horizontalAdvance(entry.name);
    if (next.x() > 0.0 && next.x() + needed > width)
      next = {0.0, next.y() + rowHeight * unit};
    layout.places.push_back(next);
    layout.width = std::max(layout.width, next.x() + needed);
    next.rx() += needed + gap * unit;
  }
  layout.height = entries.empty() ? 0.0 : next.y() + rowHeight * unit;
  return layout;
}

void paintLegend(QPainter& painter, const std::vector<LegendEntry>& entries, const LegendLayout& layout,
                 const QPointF& corner, const QColor& text) {
  const double unit = QFontMetricsF(painter.font()).height();
  const double room = roomOfMarks(entries, unit);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const LegendEntry& entry = entries[i];
    const QPointF place = corner + layout.places[i];
    painter.setPen(QPen(entry.color, 1.2));
    painter.setBrush(entry.isFilled ? QBrush(entry.color) : QBrush(Qt::NoBrush));
    paintMark(painter, entry.shape, place + QPointF(0.5 * room, 0.5 * rowHeight * unit), entry.size);
    painter.setPen(text);
    painter.drawText(QRectF(place.x() + room + wordGap * unit, place.y(), 1e4, rowHeight * unit),
                     Qt::AlignLeft | Qt::AlignVCenter, entry.name);
  }
}

} // namespace limn
