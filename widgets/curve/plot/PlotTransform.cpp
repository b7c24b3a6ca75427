// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/plot/PlotTransform.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

ValueRange keptWithin(const ValueRange& range, const ValueRange& full) {
  const double width = std::min(range.highest - range.lowest, full.highest - full.lowest);
  const double lowest = std::clamp(range.lowest, full.lowest, full.highest - width);
  return {lowest, lowest + width};
}

} // namespace

double xOfValue(const PlotTransform& t, double value) {
  return t.plot.left() + (value - t.visible.lowest) / valuePerPixel(t);
}

double valueAtX(const PlotTransform& t, double x) {
  return t.visible.lowest + (x - t.plot.left()) * valuePerPixel(t);
}

double yOfOpacity(const PlotTransform& t, double opacity) {
  return t.plot.bottom() - (t.fineLowOpacities ? std::cbrt(opacity) : opacity) * t.plot.height();
}

double opacityAtY(const PlotTransform& t, double y) {
  const double height = std::clamp((t.plot.bottom() - y) / t.plot.height(), 0.0, 1.0);
  return t.fineLowOpacities ? height * height * height : height;
}

double valuePerPixel(const PlotTransform& t) {
  return (t.visible.highest - t.visible.lowest) / t.plot.width();
}

ValueRange zoomedAtX(const PlotTransform& t, double x, double factor, const ValueRange& full) {
  const double fullWidth = full.highest - full.lowest;
  const double width =
      std::clamp((t.visible.highest - t.visible.lowest) / factor, fullWidth * 1e-5, fullWidth);
  const double share = std::clamp((x - t.plot.left()) / t.plot.width(), 0.0, 1.0);
  const double lowest = valueAtX(t, x) - share * width;
  return keptWithin({lowest, lowest + width}, full);
}

ValueRange pannedBy(const PlotTransform& t, double pixels, const ValueRange& full) {
  const double offset = pixels * valuePerPixel(t);
  return keptWithin({t.visible.lowest + offset, t.visible.highest + offset}, full);
}

ValueRange revealed(const PlotTransform& t, double value, double margin, const ValueRange& full) {
  const double x = xOfValue(t, value);
  if (x >= t.plot.left() && x <= t.plot.right())
    return t.visible;
  return pannedBy(t, x < t.plot.left() ? x - t.plot.left() - margin : x - t.plot.right() + margin, full);
}

AxisTicks niceTicks(const ValueRange& range, int most) {
  const double least = (range.highest - range.lowest) / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10.0 * power;
  for (const double multiple : {5.0, 2.0, 1.0})
    if (multiple * power >= least)
      step = multiple * power;

  AxisTicks ticks{step, {}};
  // Count in whole steps, so that no rounding error adds up.
  const double last = std::floor(range.highest / step);
  for (double i = std::ceil(range.lowest / step); i <= last; i += 1.0)
    ticks.values.push_back(i * step);
  return ticks;
}

} // namespace limn
