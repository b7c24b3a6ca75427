// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"
#include "widgets/accuracy/ChartLegend.h"
#include "widgets/plot/PlotTransform.h"

#include <QImage>

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// Which figure of an error the chart shows.
enum class ErrorMeasure { p99_9, mean };

/// A measured point as the chart shows it.
struct ChartMark {
  std::size_t index = 0; ///< in the report's points
  double ms = 0.0;
  double leastMs = 0.0;
  double mostMs = 0.0;
  double error = 0.0;        ///< 8-bit levels, > 0; the floor where the error is below it
  bool isBelowFloor = false; ///< too small to be told from none: to be read as "< error"
  bool isPareto = false;
};

/// Points that differ in step or tolerance only, from coarse to fine.
struct ChartCurve {
  std::string family;
  std::vector<ChartMark> marks;
};

/// One curve per family, in the report's order; none where the exact picture has not converged, because then
/// no error is known.
std::vector<ChartCurve> chartCurves(const AccuracyReport& report, ErrorMeasure measure);

/// A chart of error against time, both logarithmic, as one value: a curve per family of operating points, the
/// best trade-offs ringed, a line at one level ("accurate to the screen"); of random paths a thin one of the
/// law of chance as well, down to a quarter of the least error and what that takes.
struct ChartPicture {
  AccuracyReport report;
  std::vector<ChartCurve> curves; ///< of the report (chartCurves)
  ErrorMeasure measure = ErrorMeasure::p99_9;
  ChartStyle style = ChartStyle::light;
  QSizeF size;                ///< logical pixels
  double textSize = 12.0;     ///< of text and marks, logical pixels
  bool legendAtRight = false; ///< or below the plot, in as many rows as it needs
  bool plainNames = false;    ///< families are named as the window does, not as reports do
  int timeTicks = 6;          ///< at most so many
  int errorTicks = 8;         ///< at most so many
  QString title = {};         ///< empty for none
  std::optional<std::size_t> current =
      std::nullopt; ///< the point of the report that the pictures on screen use
  std::optional<std::size_t> hovered =
      std::nullopt; ///< the point under the pointer, or the one that keys walked to
};

/// Where the law of chance (1/√n) leads from the point of most paths: to a quarter of its error.
struct QuarterError {
  int paths = 0;
  double ms = 0.0;
  double error = 0.0; ///< 8-bit levels
};
/// Absent where no paths were measured.
std::optional<QuarterError> quarterError(const ChartPicture& picture);

/// Where the plot lies in the chart and how ms and levels do in it; there are curves.
PlotTransform chartPlot(const ChartPicture& picture);

/// What the legend names.
std::vector<LegendEntry> legendEntries(const ChartPicture& picture);

/// Where a point of the report stands, in the chart's pixels; absent where it is not shown.
std::optional<QPointF> positionOf(const ChartPicture& picture, std::size_t point);

/// The point nearest to a position within so many pixels of it.
std::optional<std::size_t> pointNear(const ChartPicture& picture, const QPointF& position, double radius);

/// Paints axes, curves, marks, legend and title, or why there are none; not the background.
void paintChart(QPainter& painter, const ChartPicture& picture);

/// The chart of a report as a figure of its own, with a title that names scene, size and renderer; text and
/// marks grow with the picture. Needs a QApplication, which may have no display (platform "offscreen").
QImage accuracyChartPicture(const AccuracyReport& report, const QSize& size,
                            ChartStyle style = ChartStyle::print, ErrorMeasure measure = ErrorMeasure::p99_9);

} // namespace limn
