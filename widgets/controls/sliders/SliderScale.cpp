// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/sliders/SliderScale.h"

#include <algorithm>
#include <cmath>

namespace limn {

double fractionOf(const SliderScale& scale, double value) {
  const double limited = std::clamp(value, scale.lowest, scale.highest);
  if (scale.logarithmic)
    return std::log(limited / scale.lowest) / std::log(scale.highest / scale.lowest);
  return (limited - scale.lowest) / (scale.highest - scale.lowest);
}

double valueAtFraction(const SliderScale& scale, double fraction) {
  if (fraction <= 0.0)
    return scale.lowest;
  if (fraction >= 1.0)
    return scale.highest;
  if (scale.logarithmic)
    return scale.lowest * std::pow(scale.highest / scale.lowest, fraction);
  return std::lerp(scale.lowest, scale.highest, fraction);
}

} // namespace limn
