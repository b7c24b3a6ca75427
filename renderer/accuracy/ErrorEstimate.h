// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ImageError.h"
#include "scene/Scene.h"

#include <optional>

namespace limn {

/// The error of a picture as far as pictures of other steps tell it, without an exact one (Richardson;
/// NUMERICS section 6). With I_h - I = C h^p the picture of half the step is off by |I_h - I_h/2| / (2^p -
/// 1). All figures in 8-bit levels.
struct ErrorEstimate {
  double p99_9 = 0.0;
  double mean = 0.0;
  double order = 1.0; ///< the p used, 1..2
  bool operator==(const ErrorEstimate&) const = default;
};

/// The order that three pictures show whose steps halve, from the two differences between them, kept within
/// 1..2: a difference of 0 shows no order, 1 is the careful value.
double observedOrder(double coarseDifference, double fineDifference);

/// The error of the picture of step h/2 whose difference to that of step h is `halving`, given the difference
/// `before` of the halving before it, where there was one; without it the order is taken to be 1.
ErrorEstimate errorAfterHalving(const ImageError& halving, const std::optional<ImageError>& before = {});

/// The error of the picture of step h, given the order.
ErrorEstimate errorBeforeHalving(const ImageError& halving, double order);

/// The error of the picture of step h: 2^p times that after the halving.
ErrorEstimate errorBeforeHalving(const ImageError& halving, const std::optional<ImageError>& before = {});

/// Half a level as the default early termination counts it (RENDERING section 7): what it leaves out of a
/// picture however small the step, 255 · (1 - 0.998).
inline constexpr double halfALevel = 0.51;

/// What early termination can have cost a picture of the scene: the rest of every ray that ended early, taken
/// to be as bright as what it passed before. 0 without early termination.
ImageError errorOfEarlyEnds(const Image& picture, const Scene& scene);

/// The estimate of a picture whose rays also ended early. Early ends lie within opaque tissue, errors of the
/// step at edges: of the 99.9th percentile the larger one shows, the means add.
ErrorEstimate withEarlyEnds(const ErrorEstimate& ofSteps, const ImageError& ofEnds);

} // namespace limn
