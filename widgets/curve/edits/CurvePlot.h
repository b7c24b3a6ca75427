// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"
#include "widgets/curve/edits/CurveEdits.h"
#include "widgets/curve/edits/CurveSubject.h"

#include <QString>

#include <optional>

namespace limn {

/// What one edits in a plot: a function with the points in hand, over the values of a volume.
struct CurvePlot {
  CurveSubject subject = CurveSubject::value;
  TransferFunction function;
  PointIndices selected;
  std::optional<ValueRange> values; ///< of the volume; absent without one
  QString unit;
};

/// Every value of the volume and every point, with a margin.
ValueRange fullRange(const CurvePlot& plot);

/// The smallest step of a value that matters to the data: 1 HU for CT.
double valueUnit(const CurvePlot& plot);

/// Where a point can go among the values: as far as its neighbours, or as the plot shows.
ValueRange reachOf(const CurvePlot& plot, std::size_t index);

/// An act of the user's: what the function becomes, which points are in hand then, and what undo shows.
struct CurveChange {
  TransferFunction function;
  PointIndices selected;
  QString text;
};

/// A point more, and that in hand. Texts show values with so many `decimals`.
CurveChange withPointAt(const CurvePlot& plot, double value, double opacity, int decimals);

/// A point more on the curve itself: between the point in hand and the next, or the one before the last;
/// without one in hand in the middle of the `visible` values.
CurveChange withPointBeside(const CurvePlot& plot, const ValueRange& visible, int decimals);

/// A point at another value and opacity, within its reach, and that in hand.
CurveChange withPointPlaced(const CurvePlot& plot, std::size_t index, double value, double opacity,
                            int decimals);

/// Without the points in hand, but never the last one. The neighbour is next, so that one can go on.
CurveChange withoutSelected(const CurvePlot& plot, int decimals);

/// The points in hand moved by so many units of the value to the right and hundredths of opacity up.
CurveChange nudged(const CurvePlot& plot, double units, double hundredths, int decimals);

/// What undo shows of points that moved: how many, or where the only one went.
QString movedText(std::size_t count, const QString& value);

} // namespace limn
