// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/ErrorEstimate.h"

#include <algorithm>
#include <cmath>

namespace limn {

double observedOrder(double coarseDifference, double fineDifference) {
  if (!(coarseDifference > 0.0) || !(fineDifference > 0.0))
    return 1.0;
  return std::clamp(std::log2(coarseDifference / fineDifference), 1.0, 2.0);
}

ErrorEstimate errorAfterHalving(const ImageError& halving, const std::optional<ImageError>& before) {
  const double order = before ? observedOrder(before->p99_9, halving.p99_9) : 1.0;
  const double gain = std::exp2(order) - 1.0;
  return {halving.p99_9 / gain, halving.mean / gain, order};
}

ErrorEstimate errorBeforeHalving(const ImageError& halving, const std::optional<ImageError>& before) {
  ErrorEstimate estimate = errorAfterHalving(halving, before);
  estimate.p99_9 *= std::exp2(estimate.order);
  estimate.mean *= std::exp2(estimate.order);
  return estimate;
}

} // namespace limn
