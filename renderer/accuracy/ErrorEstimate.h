// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ImageError.h"
#include "scene/Scene.h"

#include <optional>
#include <vector>

namespace limn {

/// The error of a picture as far as pictures of other steps tell it, without an exact one (Richardson;
/// HARD_CASES section 6). With I_h - I = C h^p the picture of half the step is off by |I_h - I_h/2| / (2^p -
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

/// The error of the last of many pictures whose steps halve, from the differences between them, the newest
/// last; at least one. Careful where data have edges, whose differences can fall by chance: the order is the
/// smaller of the last two observed (1.5 at most where only one was), and unless these two agree, the error
/// is at least what the difference before the last leaves at order 1.5.
ErrorEstimate errorAfterHalvings(const std::vector<ImageError>& halvings);

/// The error of the picture of step h, from the differences to that of h/2 and from there to that of h/4: at
/// least four times the second, which at order 1 is all that is left.
ErrorEstimate errorBeforeHalvings(const ImageError& first, const ImageError& second);

/// Half a level as the default early termination counts it (DEFINITION section 7): what it leaves out of a
/// picture however small the step, 255 · (1 - 0.998).
inline constexpr double halfALevel = 0.51;

/// What early termination can have cost a picture of the scene: the rest of every ray that ended early, taken
/// to be as bright as what it passed before. 0 without early termination.
ImageError errorOfEarlyEnds(const Image& picture, const Scene& scene);

/// The estimate of a picture whose rays also ended early. Early ends lie within opaque tissue, errors of the
/// step at edges: of the 99.9th percentile the larger one shows, the means add.
ErrorEstimate withEarlyEnds(const ErrorEstimate& ofSteps, const ImageError& ofEnds);

/// The estimate of a picture to which a driver's filter adds an error of its own (accuracy/Tolerance): those
/// of the step lie at edges as well, and add.
ErrorEstimate withFilter(const ErrorEstimate& estimate, const ImageError& ofFilter);

/// And with what a grid of light adds: steps and nodes are off in places that know nothing of each other.
ErrorEstimate withLight(const ErrorEstimate& estimate, const ImageError& ofLight);

/// A band of the transfer function counts where it rises or falls by at least this much opacity, or colour
/// weighted by it: the height below which `stepResolvesFunction` lets samples miss one.
inline constexpr double leastBandHeight = 0.1;

/// Whether steps of the scene's length can see the transfer function: no band of it that shows in the picture
/// is narrower than what the value commonly changes by in a step, `steepestPerMm` times its length. Where one
/// is, a picture and that of half the step may both step over it, and their difference says nothing.
/// Pre-integrated steps pass through every band, so they see it however narrow, but for those between looks
/// of labels, for which samples stand; so do projections that classify no samples.
bool stepSeesFunction(const Scene& scene, double steepestPerMm, bool isPreintegrated);

} // namespace limn
