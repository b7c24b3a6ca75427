// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/times/Timing.h"

#include <algorithm>
#include <cassert>

namespace limn {

Timing timingOf(std::vector<double> times) {
  assert(!times.empty());
  std::sort(times.begin(), times.end());
  const std::size_t half = times.size() / 2;
  const double median = times.size() % 2 == 1 ? times[half] : (times[half - 1] + times[half]) / 2.0;
  return {median, times.front(), times.back()};
}

std::vector<double> wallTimes(const std::vector<FrameCost>& frames) {
  std::vector<double> times;
  times.reserve(frames.size());
  for (const FrameCost& frame : frames)
    times.push_back(frame.ms);
  return times;
}

std::vector<double> processorTimes(const std::vector<FrameCost>& frames) {
  std::vector<double> times;
  times.reserve(frames.size());
  for (const FrameCost& frame : frames)
    times.push_back(frame.cpuMs);
  return times;
}

} // namespace limn
