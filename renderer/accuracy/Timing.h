// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace limn {

/// Many times as a reader wants them.
struct Timing {
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;
  bool operator==(const Timing&) const = default;
};

/// At least one time; of an even number the median is the mean of the middle two.
Timing timingOf(std::vector<double> times);

} // namespace limn
