// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/volume/Volume.h"

#include <QString>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace limn {

/// What the points of a curve are over. Every curve is edited as a list of control points; this says what of
/// them counts.
enum class CurveSubject {
  value,   ///< opacity and colour over the scalar
  gradient ///< opacity over the modulus of the gradient: never below 0, without colours
};

inline bool hasColors(CurveSubject subject) {
  return subject == CurveSubject::value;
}

/// Below this no point lies.
inline double lowestPlace(CurveSubject subject) {
  return subject == CurveSubject::gradient ? 0.0 : -std::numeric_limits<double>::infinity();
}

/// The function with every point where it may lie.
inline TransferFunction limitedTo(CurveSubject subject, TransferFunction function) {
  for (ControlPoint& point : function.points)
    point.value = std::max(point.value, lowestPlace(subject));
  return function;
}

/// Indices of points, ascending.
using PointIndices = std::vector<std::size_t>;

PointIndices allPoints(const TransferFunction& function);

bool contains(const PointIndices& indices, std::size_t index);

/// With an index more, or unchanged where it is among them; and without it.
PointIndices withIndex(const PointIndices& indices, std::size_t index);
PointIndices withoutIndex(const PointIndices& indices, std::size_t index);

/// The point that Tab (or, not `next`, Shift+Tab) takes in hand after the `selected` of `count`; none where
/// the focus goes on, so that nobody is caught.
std::optional<std::size_t> pointAfter(const PointIndices& selected, std::size_t count, bool next);

/// Moves several points together. The value offset is shortened where a moved point would pass one that
/// stays; opacities stop at 0 and 1 one by one.
TransferFunction withPointsMoved(const TransferFunction& function, const PointIndices& indices,
                                 double valueOffset, double opacityOffset);

/// The middle of the function's extent along the values; 0 without points.
double middleValue(const TransferFunction& function);

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
