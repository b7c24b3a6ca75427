// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/FigureText.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace limn {
namespace {

std::string sentenceOf(const MeasuredPoint& point) {
  return familyOf(point.point) + ", " + stepOf(point.point) + ": within " + threeDigits(point.error.p99_9) +
         " of 255 levels, " + threeDigits(point.ms.median) + " ms";
}

} // namespace

std::string threeDigits(double value) {
  if (value == 0.0)
    return "0";
  if (!std::isfinite(value))
    return "infinite";
  const int whole = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
  char text[48];
  if (whole < -2)
    std::snprintf(text, sizeof text, "%.1e", value);
  else
    std::snprintf(text, sizeof text, "%.*f", std::max(0, 3 - std::max(whole, 0)), value);
  return text;
}

std::string errorText(double levels, double least, const ReferenceFacts& reference) {
  if (!reference.converged)
    return "not converged";
  return levels < least ? "< " + threeDigits(least) : threeDigits(levels);
}

std::string p99_9Text(const ImageError& error, const ReferenceFacts& reference) {
  return errorText(error.p99_9, leastP99_9(reference), reference);
}

std::string meanText(const ImageError& error, const ReferenceFacts& reference) {
  return errorText(error.mean, leastMean(reference), reference);
}

std::string referenceSentence(const ReferenceFacts& reference) {
  const std::string step =
      reference.fineness
          ? "with error-controlled steps of fineness " + threeDigits(*reference.fineness)
          : "at a step of 1/" + std::to_string(std::lround(1.0 / reference.stepVoxels)) + " voxel";
  if (!reference.converged)
    return "Not converged: " + step + " the exact picture still changed by " +
           threeDigits(reference.lastChangeLevels) + " levels (99.9th percentile), so no error is told" +
           (reference.isInFloats ? "; in double precision, without --exact-by, it may converge." : ".");
  const std::string floats = ", and which floats move by " + threeDigits(floatP99_9) + " levels at most";
  return "Errors are measured against a picture in " +
         std::string(reference.isInFloats ? "single" : "double") + " precision " + step +
         ", whose last halving changed it by " + threeDigits(reference.lastChangeLevels) +
         " levels (99.9th percentile; mean " + threeDigits(reference.lastMeanChange) + ")" +
         (reference.isInFloats ? floats : "") + ".";
}

std::string wishWithinLevels(const std::vector<MeasuredPoint>& points, double levels) {
  if (const MeasuredPoint* point = fastestWithin(points, levels))
    return "The fastest within " + threeDigits(levels) + " levels: " + sentenceOf(*point) + ".";
  const auto closest = std::ranges::min_element(
      points, [](const auto& a, const auto& b) { return a.error.p99_9 < b.error.p99_9; });
  if (closest == points.end())
    return "Nothing was measured.";
  return "None stays within " + threeDigits(levels) + " levels; the closest is " + sentenceOf(*closest) + ".";
}

std::string wishWithinMs(const std::vector<MeasuredPoint>& points, double ms) {
  if (const MeasuredPoint* point = mostAccurateWithin(points, ms))
    return "The most accurate in " + threeDigits(ms) + " ms: " + sentenceOf(*point) + ".";
  const auto fastest = std::ranges::min_element(
      points, [](const auto& a, const auto& b) { return a.ms.median < b.ms.median; });
  if (fastest == points.end())
    return "Nothing was measured.";
  return "None takes at most " + threeDigits(ms) + " ms; the fastest is " + sentenceOf(*fastest) + ".";
}

} // namespace limn
