// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/Timing.h"

#include <vector>

namespace limn {

/// What one picture cost.
struct FrameCost {
  double ms = 0.0;    ///< on the clock, until the picture is finished
  double cpuMs = 0.0; ///< of all threads
};

/// The wall times and the processor times of frames.
std::vector<double> wallTimes(const std::vector<FrameCost>& frames);
std::vector<double> processorTimes(const std::vector<FrameCost>& frames);

} // namespace limn
