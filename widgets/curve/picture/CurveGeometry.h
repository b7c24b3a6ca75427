// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/curve/picture/CurveEdits.h"
#include "widgets/plot/PlotTransform.h"

namespace limn {

inline constexpr double pointDiameter = 10.0; ///< pixels

/// The bar above the plot that spans the curve: the grip at its middle moves the whole curve, its ends widen
/// it. It stays above the plot: what lies beyond the visible values stands at the plot's edge, where the grip
/// can still be taken hold of and an end only points the way.
struct CurveBar {
  QPointF start;
  QPointF grip;
  QPointF end;
  bool startVisible = true;
  bool endVisible = true;
};

/// What lies under the pointer. `index` is a point's.
struct CurveHit {
  enum class Part { nothing, point, curve, barGrip, barEnd };
  Part part = Part::nothing;
  std::size_t index = 0;
};

/// Where a point stands, pixels; beyond the plot where its value is not visible.
QPointF positionOf(const PlotTransform& transform, const ControlPoint& point);

/// The opacity curve over the visible values, from the plot's left edge to its right; steps are vertical.
QPolygonF curvePolygon(const PlotTransform& transform, const TransferFunction& function);

/// Nothing for an empty function.
std::optional<CurveBar> curveBar(const PlotTransform& transform, const TransferFunction& function);

/// What a press at `position` takes hold of: the nearest point first, then the bar, then the curve.
CurveHit hitAt(const PlotTransform& transform, const TransferFunction& function, const QPointF& position);

/// The points inside a rectangle of pixels.
PointIndices pointsInside(const PlotTransform& transform, const TransferFunction& function,
                          const QRectF& band);

} // namespace limn
