// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/ConvergedPicture.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double firstStep = 0.25;
constexpr double smallestStep = 1.0 / 1024.0;
constexpr int leastHalvings = 4; ///< that are tried, however fine the scene's own step
constexpr double enoughP99_9 = 0.15;
constexpr double enoughMean = 0.005;

// A pixel rests when a halving changes no channel by more than this many levels: as the changes shrink by
// half at least, all later ones together stay below it, and the mean of 0.005 cannot come from these pixels.
constexpr double stillLevels = 0.002;

bool changes(const glm::dvec4& before, const glm::dvec4& after) {
  const glm::dvec4 change = glm::abs(after - before) * 255.0;
  return !(std::max({change.r, change.g, change.b, change.a}) <= stillLevels);
}

} // namespace

ConvergedPicture convergedPicture(const Scene& scene, const glm::ivec2& size, const DrawPrecisely& draw,
                                  const ReportProgress& report) {
  Scene finer = scene;
  finer.quality.earlyTermination = 1.0;
  finer.quality.jitter = false;
  finer.quality.toleranceLevels.reset();
  finer.quality.fineness.reset();
  const double first = std::min(firstStep, scene.quality.stepVoxels);
  const double smallest = std::min(smallestStep, std::ldexp(first, -leastHalvings));
  finer.quality.stepVoxels = first;
  const auto count = static_cast<std::size_t>(size.x) * size.y;
  ConvergedPicture result{PrecisePixels(count, glm::dvec4(0.0)), {}};
  std::vector<std::uint8_t> wanted(count, 1);
  const auto tell = [&](double fraction) {
    if (report)
      report(fraction, "Drawing the exact picture");
  };
  tell(0.0);
  draw(finer, size, wanted, result.pixels);
  result.facts.stepVoxels = finer.quality.stepVoxels;
  double fraction = 0.0;
  while (!result.facts.converged) {
    finer.quality.stepVoxels /= 2.0;
    if (finer.quality.stepVoxels < smallest)
      break;
    // How many halvings it will take is unknown: each takes a part of what is left.
    fraction += (1.0 - fraction) / 4.0;
    tell(fraction);
    const PrecisePixels before = result.pixels;
    draw(finer, size, wanted, result.pixels);
    const ImageError change = imageError(before, result.pixels);
    result.facts = {change.p99_9 <= enoughP99_9 && change.mean <= enoughMean, finer.quality.stepVoxels,
                    change.p99_9, change.mean};
    for (std::size_t i = 0; i < count; ++i)
      wanted[i] = wanted[i] && changes(before[i], result.pixels[i]) ? 1 : 0;
  }
  return result;
}

double leastP99_9(const ReferenceFacts& facts) {
  return 3.0 * facts.lastChangeLevels;
}

double leastMean(const ReferenceFacts& facts) {
  return 3.0 * facts.lastMeanChange;
}

} // namespace limn
