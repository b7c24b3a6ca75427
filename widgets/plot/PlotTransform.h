// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <QPolygonF>
#include <QRectF>

#include <optional>
#include <vector>

namespace limn {

/// How the values of an axis lie along it. Logarithmic axes show values > 0; the cube root gives low
/// opacities room: of 0..1, 0.001 is a tenth.
enum class AxisScale { linear, logarithmic, cubeRoot };

/// Maps pairs of values to pixels of a plot and back, in double precision: across from left to right, up from
/// bottom to top.
struct PlotTransform {
  QRectF plot{0.0, 0.0, 1.0, 1.0}; ///< pixels
  ValueRange visible{0.0, 1.0};    ///< values at the plot's left and right edge, lowest < highest
  AxisScale upScale = AxisScale::linear;
  ValueRange up{0.0, 1.0}; ///< values at the plot's bottom and top, lowest < highest; opacities unless told
  AxisScale acrossScale = AxisScale::linear;
  bool operator==(const PlotTransform&) const = default;
};

/// Between values and pixels across, beyond the plot, too.
double xOfValue(const PlotTransform& transform, double value);
double valueAtX(const PlotTransform& transform, double x);

/// The height of an opacity, or of what else the plot has upwards, in pixels down.
double yOfOpacity(const PlotTransform& transform, double opacity);

/// The opacity at a height, limited to those of the plot.
double opacityAtY(const PlotTransform& transform, double y);

/// Values per pixel across; the axis is linear, here and in what follows.
double valuePerPixel(const PlotTransform& transform);

/// The value with the digits that tell one pixel from the next: whole where a pixel spans one or more.
double roundedToPixel(const PlotTransform& transform, double value);

/// The visible range made `factor` times narrower around the value at `x`, which stays where it is. It stays
/// within `full` and no narrower than a 100 000th of it.
ValueRange zoomedAtX(const PlotTransform& transform, double x, double factor, const ValueRange& full);

/// The visible range moved by so many pixels (positive: to higher values), within `full`.
ValueRange pannedBy(const PlotTransform& transform, double pixels, const ValueRange& full);

/// The visible range moved no further than brings `value` to `margin` pixels from the plot's edge, within
/// `full`; unchanged where it is in sight.
ValueRange revealed(const PlotTransform& transform, double value, double margin, const ValueRange& full);

/// The index of the place nearest to `position` and within so many pixels of it; of places on one spot the
/// last, which is painted on top.
std::optional<std::size_t> nearestPlace(const std::vector<QPointF>& places, const QPointF& position,
                                        double radius);

/// How far a position lies from a line of pieces, pixels; 1e9 from a line without any.
double distanceToLine(const QPolygonF& line, const QPointF& position);

/// Whether a line of pieces runs through a box.
bool runsThrough(const QPolygonF& line, const QRectF& box);

} // namespace limn
