// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/curve/picture/CurveEdits.h"
#include "widgets/curve/picture/CurveGeometry.h"
#include "widgets/curve/picture/HistogramPicture.h"
#include "widgets/curve/picture/Tissue.h"
#include "widgets/theme/Theme.h"

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

/// What that usually is; only Hounsfield units tell.
std::optional<Tissue> toldTissue(const CanvasPicture& picture);

/// "310 HU · opacity 0.42 · bone, dense contrast agent"; empty where nothing is told of.
QString readOutText(const CanvasPicture& picture);

/// Where the name of a tissue lies that begins at `left`: at the upper edge of the plot or, where the curve
/// runs there, in the lowest row through which neither that nor the histogram's edge runs; where there is
/// none, at the lower edge. Pixels.
QRectF tissueNamePlace(const CanvasPicture& picture, double left, double width);

/// Where a box of `size` beside the value at `x` lies within the plot: at its upper or lower edge or a row
/// between them, under `x` or beside it, the first place that covers neither the curve nor a point. Where
/// there is none, the first that covers no point; then under `x` at the upper edge. Pixels.
QRectF clearPlace(const PlotTransform& transform, const TransferFunction& function, const QSizeF& size,
                  double x);

/// Where the box of a point at `centre` lies: above it, or, where that would cover a point, in a clear place.
QRectF placeAbove(const PlotTransform& transform, const TransferFunction& function, const QSizeF& size,
                  const QPointF& centre);

} // namespace limn
