// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/FrameCost.h"

namespace limn {

std::vector<double> wallTimes(const std::vector<FrameCost>& frames) {
  std::vector<double> times;
  for (const FrameCost& frame : frames)
    times.push_back(frame.ms);
  return times;
}

std::vector<double> processorTimes(const std::vector<FrameCost>& frames) {
  std::vector<double> times;
  for (const FrameCost& frame : frames)
    times.push_back(frame.cpuMs);
  return times;
}

} // namespace limn
