// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/ConvergedPicture.h"

#include "accuracy/sweep/Halvings.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double enoughP99_9 = 0.15;
constexpr double enoughMean = 0.005;
constexpr double enoughMeanOfLocal = 0.0005; ///< they cost little

// A pixel rests when a halving changes no channel by more than this many levels: as the changes shrink by
// half at least, all later ones together stay below it, and the mean of 0.005 cannot come from these pixels.
constexpr double stillLevels = 0.002;

bool changes(const glm::dvec4& before, const glm::dvec4& after) {
  const glm::dvec4 change = glm::abs(after - before) * 255.0;
  return !(std::max({change.r, change.g, change.b, change.a}) <= stillLevels);
}

} // namespace

ConvergedPicture convergedPicture(const Scene& scene, const glm::ivec2& size, const DrawPrecisely& draw,
                                  const ReportProgress& report, StepControl control) {
  Halvings halvings(scene.quality, scene.projection, control);
  Scene finer = scene;
  finer.quality = halvings.quality();
  const auto count = static_cast<std::size_t>(size.x) * size.y;
  ConvergedPicture result{PrecisePixels(count, glm::dvec4(0.0)), {}};
  std::vector<std::uint8_t> wanted(count, 1);
  const auto tell = [&](double fraction) {
    if (report)
      report(fraction, Message::tr("Drawing the exact picture"));
  };
  tell(0.0);
  draw(finer, size, wanted, result.pixels);
  result.facts.stepVoxels = halvings.stepVoxels();
  result.facts.fineness = finer.quality.fineness;
  result.facts.converged = halvings.isExact();
  double fraction = 0.0;
  while (!result.facts.converged) {
    if (!halvings.halve())
      break;
    finer.quality = halvings.quality();
    // How many halvings it will take is unknown: each takes a part of what is left.
    fraction += (1.0 - fraction) / 4.0;
    tell(fraction);
    const PrecisePixels before = result.pixels;
    draw(finer, size, wanted, result.pixels);
    const ImageError change = imageError(before, result.pixels);
    const double mostMean = finer.quality.fineness ? enoughMeanOfLocal : enoughMean;
    result.facts = {change.p99_9 <= enoughP99_9 && change.mean <= mostMean,
                    halvings.stepVoxels(),
                    finer.quality.fineness,
                    change.p99_9,
                    change.mean,
                    false};
    for (std::size_t i = 0; i < count; ++i)
      wanted[i] = wanted[i] && changes(before[i], result.pixels[i]) ? 1 : 0;
  }
  return result;
}

double leastP99_9(const ReferenceFacts& facts) {
  return 3.0 * facts.lastChangeLevels + (facts.isInFloats ? floatP99_9 : 0.0);
}

double leastMean(const ReferenceFacts& facts) {
  return 3.0 * facts.lastMeanChange + (facts.isInFloats ? floatMean : 0.0);
}

} // namespace limn
