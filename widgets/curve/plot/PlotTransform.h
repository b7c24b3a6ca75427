// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <QRectF>

#include <vector>

namespace limn {

/// Maps (value, opacity) to pixels of the plot and back, in double precision: values left to right, opacity
/// bottom to top.
struct PlotTransform {
  QRectF plot{0.0, 0.0, 1.0, 1.0}; ///< pixels
  ValueRange visible{0.0, 1.0};    ///< values at the plot's left and right edge, lowest < highest
  bool fineLowOpacities = false;   ///< the axis shows the cube root, so 0.001 is a tenth of the height
  bool operator==(const PlotTransform&) const = default;
};

/// Between values and pixels across, beyond the plot, too.
double xOfValue(const PlotTransform& transform, double value);
double valueAtX(const PlotTransform& transform, double x);

/// The height of an opacity, 0..1, in pixels down.
double yOfOpacity(const PlotTransform& transform, double opacity);

/// The opacity at a height, limited to 0..1.
double opacityAtY(const PlotTransform& transform, double y);

/// Values per pixel.
double valuePerPixel(const PlotTransform& transform);

/// The visible range made `factor` times narrower around the value at `x`, which stays where it is. It stays
/// within `full` and no narrower than a 100 000th of it.
ValueRange zoomedAtX(const PlotTransform& transform, double x, double factor, const ValueRange& full);

/// The visible range moved by so many pixels (positive: to higher values), within `full`.
ValueRange pannedBy(const PlotTransform& transform, double pixels, const ValueRange& full);

/// The visible range moved no further than brings `value` to `margin` pixels from the plot's edge, within
/// `full`; unchanged where it is in sight.
ValueRange revealed(const PlotTransform& transform, double value, double margin, const ValueRange& full);

/// Labelled places on an axis.
struct AxisTicks {
  double step = 1.0; ///< 1, 2 or 5 times a power of ten
  std::vector<double> values;
};

/// Round values inside `range` (lowest < highest), at most `most` > 1 of them where that is possible.
AxisTicks niceTicks(const ValueRange& range, int most);

} // namespace limn
