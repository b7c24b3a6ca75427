// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/plot/AxisTicks.h"

#include <cmath>

namespace limn {

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
