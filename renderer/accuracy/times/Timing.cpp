// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/times/Timing.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limn {

std::optional<double> timeAtError(std::vector<ErrorAndTime> curve, double meanError) {
  std::optional<double> least;
  const auto offer = [&least](double ms) { least = std::min(least.value_or(ms), ms); };
  std::ranges::sort(curve, std::less(), &ErrorAndTime::cpuMs);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const ErrorAndTime& point = curve[i];
    if (point.meanError > meanError)
      continue;
    offer(point.cpuMs);
    // Between it and a faster one that errs more.
    for (std::size_t k = 0; k < i; ++k)
      if (curve[k].meanError > meanError && point.meanError > 0.0) {
        const double share =
            std::log(meanError / curve[k].meanError) / std::log(point.meanError / curve[k].meanError);
        offer(curve[k].cpuMs * std::pow(point.cpuMs / curve[k].cpuMs, share));
      }
  }
  return least;
}

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
