// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"

namespace limn {

/// An error for people: three digits, "< x" where it cannot be told from `least`, "not converged" without a
/// converged picture.
std::string errorText(double levels, double least, const ReferenceFacts& reference);

/// The 99.9th percentile and the mean of a point that way.
std::string p99_9Text(const ImageError& error, const ReferenceFacts& reference);
std::string meanText(const ImageError& error, const ReferenceFacts& reference);

/// A number with three digits and no exponent from 0.001 on.
std::string threeDigits(double value);

/// What the exact picture is and how certain, one sentence.
std::string referenceSentence(const ReferenceFacts& reference);

/// Of points of random paths: how the error fell with their number beside the law of 1/√n, and what a quarter
/// of it would cost by that. Empty for fewer than two such points.
Message lawOfPaths(const std::vector<MeasuredPoint>& points);

/// By that law, how many paths of each pixel and how long it takes until 99.9 % of the colours lie within so
/// many levels; and how many levels a picture that may take so long has. Absent without such a point.
struct PathsNeeded {
  double paths = 0.0;
  double ms = 0.0;
  double levels = 0.0;
};
std::optional<PathsNeeded> pathsWithinLevels(const std::vector<MeasuredPoint>& points, double levels);
std::optional<PathsNeeded> pathsWithinMs(const std::vector<MeasuredPoint>& points, double ms);

/// What a wish got, one sentence: the point that keeps it, or that none does and what came closest.
std::string wishWithinLevels(const std::vector<MeasuredPoint>& points, double levels);
std::string wishWithinMs(const std::vector<MeasuredPoint>& points, double ms);

/// Whether the costs measured justify how the program decides, a sentence each: one for every other way that
/// was as accurate at both steps (errors not above its own by more than the converged picture may be off:
/// 0.15 level at the 99.9th percentile, 0.005 in the mean, DEFINITION section 9) and took at most 0.9 of the
/// time; a single one where there is none. Nothing where nothing was measured.
std::vector<std::string> verdictOn(const std::vector<DecisionCost>& costs);

} // namespace limn
