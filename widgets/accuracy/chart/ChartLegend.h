// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/accuracy/chart/ChartLook.h"

#include <QFont>
#include <QPointF>
#include <QString>

#include <vector>

class QPainter;

namespace limn {

/// A name below the chart with its mark.
struct LegendEntry {
  QString name;
  QColor color;
  QScatterSeries::MarkerShape shape = QScatterSeries::MarkerShapeCircle;
  double size = 0.0; ///< of the mark
  bool isFilled = true;
};

/// Names in as many rows as a width needs: Qt's own legend below a chart has one row and cuts names.
struct LegendLayout {
  std::vector<QPointF> places; ///< of each entry the upper left corner, from the legend's own
  double height = 0.0;
};
/// `width` in logical pixels; an entry that is wider has a row of its own.
LegendLayout legendLayout(const std::vector<LegendEntry>& entries, const QFont& font, double width);

/// Paints the names in `text`, the upper left corner of the legend at `corner`.
void paintLegend(QPainter& painter, const std::vector<LegendEntry>& entries, const LegendLayout& layout,
                 const QPointF& corner, const QColor& text);

} // namespace limn
