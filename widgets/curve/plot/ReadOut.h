// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/curve/plot/CanvasPicture.h"
#include "widgets/curve/plot/Tissue.h"

namespace limn {

/// The value that the plot tells of, scalar units: that of the point whose numbers show, otherwise the one
/// under the pointer; absent where there is neither.
std::optional<double> toldValue(const CanvasPicture& picture);

/// What that usually is; only Hounsfield units tell.
std::optional<Tissue> toldTissue(const CanvasPicture& picture);

/// "310 HU · opacity 0.42 · bone, dense contrast agent"; empty where nothing is told of.
QString readOutText(const CanvasPicture& picture);

/// Where a box of `size` beside the value at `x` lies within the plot: at its upper or lower edge or a row
/// between them, under `x` or beside it, the first place that covers neither the curve nor a point. Where
/// there is none, the first that covers no point; then under `x` at the upper edge. Pixels.
QRectF clearPlace(const PlotTransform& transform, const TransferFunction& function, const QSizeF& size,
                  double x);

/// Where the box of a point at `centre` lies: above it, or, where that would cover a point, in a clear place.
QRectF placeAbove(const PlotTransform& transform, const TransferFunction& function, const QSizeF& size,
                  const QPointF& centre);

} // namespace limn
