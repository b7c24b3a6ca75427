// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/FigureText.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace limn {
namespace {

// The point of most paths, whose figures are the surest.
const MeasuredPoint* mostPathsOf(const std::vector<MeasuredPoint>& points) {
  const MeasuredPoint* most = nullptr;
  for (const MeasuredPoint& point : points)
    if (point.point.paths && point.error.p99_9 > 0.0 && (!most || *point.point.paths > *most->point.paths))
      most = &point;
  return most;
}

// By 1/√n from a point on: `factor` times its paths.
PathsNeeded scaledPaths(const MeasuredPoint& from, double factor) {
  return {factor * *from.point.paths, factor * from.ms.median, from.error.p99_9 / std::sqrt(factor)};
}

// Two digits that count, and none behind the point from 10 on.
Message briefly(double number) {
  return number < 10.0 ? Message::rounded(number, 2) : Message::fixed(number, 0);
}

std::string pathsSentence(const PathsNeeded& needed) {
  return "By the law of 1/√n " + std::to_string(std::llround(std::ceil(needed.paths))) +
         " paths a pixel take " + threeDigits(1e-3 * needed.ms) + " s and lie within " +
         threeDigits(needed.levels) + " levels (99.9th percentile of the standard error).";
}

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
  if (reference.isByChance)
    return "Errors are the standard errors of random paths, told by what paths of one pixel differ by; no "
           "other picture is needed for them.";
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

Message lawOfPaths(const std::vector<MeasuredPoint>& points) {
  const MeasuredPoint* most = mostPathsOf(points);
  const MeasuredPoint* fewest = nullptr;
  for (const MeasuredPoint& point : points)
    if (point.point.paths && point.error.rms > 0.0 && (!fewest || *point.point.paths < *fewest->point.paths))
      fewest = &point;
  if (!most || !fewest || most == fewest)
    return {};
  const double power = std::log(fewest->error.rms / most->error.rms) /
                       std::log(double(*most->point.paths) / *fewest->point.paths);
  return Message::tr("From %1 to %2 paths a pixel the error (RMS) falls as their number to the power of −%3; "
                     "the law of chance is −0.5. A quarter of it, %4 instead of %5 levels, takes 16 times as "
                     "many paths and as long: %6 paths, %7 s.")
      .arg(*fewest->point.paths)
      .arg(*most->point.paths)
      .arg(Message::rounded(power, 2), briefly(most->error.rms / 4.0), briefly(most->error.rms))
      .arg(16 * *most->point.paths)
      .arg(briefly(16e-3 * most->ms.median));
}

std::optional<PathsNeeded> pathsWithinLevels(const std::vector<MeasuredPoint>& points, double levels) {
  const MeasuredPoint* most = mostPathsOf(points);
  return most ? std::optional(scaledPaths(*most, std::pow(most->error.p99_9 / levels, 2.0))) : std::nullopt;
}

std::optional<PathsNeeded> pathsWithinMs(const std::vector<MeasuredPoint>& points, double ms) {
  const MeasuredPoint* most = mostPathsOf(points);
  return most ? std::optional(scaledPaths(*most, ms / std::max(most->ms.median, 1e-6))) : std::nullopt;
}

std::string wishWithinLevels(const std::vector<MeasuredPoint>& points, double levels) {
  if (const auto needed = pathsWithinLevels(points, levels))
    return pathsSentence(*needed);
  if (const MeasuredPoint* point = fastestWithin(points, levels))
    return "The fastest within " + threeDigits(levels) + " levels: " + sentenceOf(*point) + ".";
  const auto closest = std::ranges::min_element(
      points, [](const auto& a, const auto& b) { return a.error.p99_9 < b.error.p99_9; });
  if (closest == points.end())
    return "Nothing was measured.";
  return "None stays within " + threeDigits(levels) + " levels; the closest is " + sentenceOf(*closest) + ".";
}

std::string wishWithinMs(const std::vector<MeasuredPoint>& points, double ms) {
  if (const auto needed = pathsWithinMs(points, ms))
    return pathsSentence(*needed);
  if (const MeasuredPoint* point = mostAccurateWithin(points, ms))
    return "The most accurate in " + threeDigits(ms) + " ms: " + sentenceOf(*point) + ".";
  const auto fastest = std::ranges::min_element(
      points, [](const auto& a, const auto& b) { return a.ms.median < b.ms.median; });
  if (fastest == points.end())
    return "Nothing was measured.";
  return "None takes at most " + threeDigits(ms) + " ms; the fastest is " + sentenceOf(*fastest) + ".";
}

} // namespace limn
