// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QScatterSeries>

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

/// How a curve is told from the others: colours that people with every common kind of colour vision tell
/// apart, and a mark of its own, because colours alone may not be seen or printed.
struct CurveLook {
  QColor color;
  QScatterSeries::MarkerShape shape = QScatterSeries::MarkerShapeCircle;
  bool isDashed = false; ///< from the ninth curve on
};

/// `curve` ≥ 0.
CurveLook curveLook(ChartStyle style, int curve);

} // namespace limn
