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

/// What one picture cost.
struct FrameCost {
  double ms = 0.0;    ///< on the clock, until the picture is finished
  double cpuMs = 0.0; ///< of all threads
};

/// The wall times and the processor times of frames.
std::vector<double> wallTimes(const std::vector<FrameCost>& frames);
std::vector<double> processorTimes(const std::vector<FrameCost>& frames);

} // namespace limn
