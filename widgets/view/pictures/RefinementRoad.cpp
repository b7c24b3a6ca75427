// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/RefinementRoad.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {

double msOfHalvings(const std::vector<std::optional<ErrorEstimate>>& rough, double stepVoxels,
                    double pictureMs, double smallestStepVoxels) {
  constexpr double never = std::numeric_limits<double>::infinity();
  double halvings = 1.0; // the first one tells how large the error is
  for (const std::optional<ErrorEstimate>& estimate : rough) {
    if (!estimate)
      return never;
    const double needed = std::log2(std::max(estimate->p99_9, halfALevel) / halfALevel) / estimate->order;
    halvings = std::max(halvings, std::ceil(needed));
  }
  if (stepVoxels * std::exp2(-halvings) < smallestStepVoxels)
    return never;
  return pictureMs * (std::exp2(halvings + 1.0) - 2.0);
}

bool isToleranceShorter(const std::vector<NeededSteps>& needed, double halvingMs, double patienceMs) {
  double ms = 0.0;
  for (const NeededSteps& steps : needed) {
    if (!steps.holds)
      return false;
    ms += steps.expectedMs;
  }
  return !needed.empty() && ms < halvingMs && ms <= patienceMs;
}

} // namespace limn
