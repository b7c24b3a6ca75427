// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QFont>
#include <QPointF>
#include <QString>

#include <vector>

class QPainter;

namespace limn {

/// For a dark or light window, or for white paper.
enum class ChartStyle { dark, light, print };

/// The colours of a chart but for its curves.
struct ChartColors {
  QColor background;
  QColor text;
  QColor secondaryText;
  QColor grid;
  QColor border; ///< of the plot
  QColor accent; ///< the current point
  QColor trade;  ///< what joins the best trade-offs
};

ChartColors chartColors(ChartStyle style);

enum class MarkShape { circle, square, triangle, diamond, pentagon, star };

/// How a curve is told from the others: colours that people with every common kind of colour vision tell
/// apart, and a mark of its own, because colours alone may not be seen or printed.
struct CurveLook {
  QColor color;
  MarkShape shape = MarkShape::circle;
  bool isDashed = false; ///< from the ninth curve on
};

/// `curve` ≥ 0.
CurveLook curveLook(ChartStyle style, int curve);

/// Paints a mark `size` pixels wide with the painter's pen and brush.
void paintMark(QPainter& painter, MarkShape shape, const QPointF& centre, double size);

/// A name beside or below the chart with its mark.
struct LegendEntry {
  QString name;
  QColor color;
  MarkShape shape = MarkShape::circle;
  double size = 0.0; ///< of the mark
  bool isFilled = true;
};

/// Names in as many rows as a width needs.
struct LegendLayout {
  std::vector<QPointF> places; ///< of each entry the upper left corner, from the legend's own
  double width = 0.0;          ///< of the longest row
  double height = 0.0;
};
/// `width` in logical pixels; an entry that is wider has a row of its own.
LegendLayout legendLayout(const std::vector<LegendEntry>& entries, const QFont& font, double width);

/// Paints the names in `text`, the upper left corner of the legend at `corner`.
void paintLegend(QPainter& painter, const std::vector<LegendEntry>& entries, const LegendLayout& layout,
                 const QPointF& corner, const QColor& text);

} // namespace limn
