// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/Theme.h"
#include "widgets/curve/edits/CurveSubject.h"
#include "widgets/curve/plot/CurveGeometry.h"
#include "widgets/curve/plot/HistogramPicture.h"

#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace limn {

/// A value that is pointed out on the axis.
struct ValueMark {
  double value = 0.0;
  bool isProbed = false; ///< it lies under the pointer in the picture, otherwise at the slices' crosshair
  bool operator==(const ValueMark&) const = default;
};

/// Everything the plot shows, as one value for the painting functions.
struct CanvasPicture {
  CurveSubject subject = CurveSubject::value;
  TransferFunction function;
  PlotTransform transform;
  ThemeColors colors;
  QString unit;
  int decimals = 0;           ///< of shown values
  HistogramPicture histogram; ///< null without a volume
  QString hint;               ///< in the middle of the plot, empty for none
  PointIndices selected;
  std::optional<std::size_t> hoveredPoint;
  std::optional<double> hoveredValue;
  std::optional<ValueMark> mark;
  std::optional<double> pinnedValue;  ///< kept from a click in the picture
  std::optional<QRectF> band;         ///< of the selection under way
  std::optional<std::size_t> readOut; ///< the point whose numbers show beside it
  CurveHit::Part hoveredPart = CurveHit::Part::nothing;
  bool focused = false;
};

/// Margins around the plot, pixels: room for the bar above, opacity labels left, the colour strip (where the
/// curve has colours) and ticks below.
inline constexpr double plotLeft = 52.0;
inline constexpr double plotTop = 20.0;
inline constexpr double plotRight = 12.0;
inline constexpr double ticksBelow = 25.0;
inline constexpr double stripBelow = 15.0;

/// The plot in a widget of this size, pixels; never narrower or lower than 20.
QRectF plotWithin(const QSizeF& size, CurveSubject subject);

/// Of the curve's colours beneath it: so faint that the histogram's edge stands out from any of them.
inline constexpr double colorsOpacity = 0.24;

/// Grid, axes, tick labels and the colour strip.
void paintAxes(QPainter& painter, const CanvasPicture& picture);

/// Histogram, curve with its colours beneath, bar, marked values, points, selection band and read-outs.
void paintCurve(QPainter& painter, const CanvasPicture& picture);

/// One row of the function's colours over the visible values, so many columns to a logical pixel.
QImage colorRow(const CanvasPicture& picture, double columnsPerPixel = 1.0);

} // namespace limn
