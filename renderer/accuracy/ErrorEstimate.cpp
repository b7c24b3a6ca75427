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

ErrorEstimate errorBeforeHalving(const ImageError& halving, double order) {
  const double share = std::exp2(order) / (std::exp2(order) - 1.0);
  return {share * halving.p99_9, share * halving.mean, order};
}

ErrorEstimate errorBeforeHalving(const ImageError& halving, const std::optional<ImageError>& before) {
  ErrorEstimate estimate = errorAfterHalving(halving, before);
  estimate.p99_9 *= std::exp2(estimate.order);
  estimate.mean *= std::exp2(estimate.order);
  return estimate;
}

ImageError errorOfEarlyEnds(const Image& picture, const Scene& scene) {
  const bool canEnd =
      scene.projection == Projection::composite || scene.projection == Projection::compositeIsosurface;
  const double end = scene.quality.earlyTermination;
  if (!canEnd || end >= 1.0)
    return {};
  Image whole = picture;
  for (glm::vec4& pixel : whole.pixels)
    if (pixel.a >= static_cast<float>(end))
      pixel /= pixel.a;
  return imageError(picture, whole);
}

ErrorEstimate withEarlyEnds(const ErrorEstimate& ofSteps, const ImageError& ofEnds) {
  return {std::max(ofSteps.p99_9, ofEnds.p99_9), ofSteps.mean + ofEnds.mean, ofSteps.order};
}

} // namespace limn
