// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/times/EqualError.h"

#include <algorithm>
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

} // namespace limn
