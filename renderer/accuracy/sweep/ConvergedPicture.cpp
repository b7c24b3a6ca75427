// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/ConvergedPicture.h"

#include "scene/ProjectionFacts.h"
#include "scene/steps/LocalSteps.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double firstStep = 0.25;
constexpr double smallestStep = 1.0 / 1024.0;
constexpr double firstFineness = 6.0;
constexpr int leastHalvings = 4; ///< that are tried, however fine the scene's own step
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

// Qualities whose steps halve.
class Halvings {
public:
  Halvings(const Quality& quality, Projection projection, StepControl control)
      : m_quality(quality), m_isLocal(control == StepControl::local && integrates(projection)),
        m_isEqual(!m_isLocal || showsSurface(projection)) {
    m_quality.earlyTermination = 1.0;
    m_quality.jitter = false;
    m_quality.toleranceLevels.reset();
    m_quality.fineness.reset();
    m_quality.stepVoxels = std::min(firstStep, quality.stepVoxels);
    m_smallestStep = std::min(smallestStep, std::ldexp(m_quality.stepVoxels, -leastHalvings));
    if (m_isLocal) {
      m_quality.toleranceLevels = 1.0; // any: the fineness is what counts
      m_quality.fineness = firstFineness;
    }
  }

  const Quality& quality() const { return m_quality; }

  // False where the steps cannot be halved any more.
  bool halve() {
    if (m_isEqual)
      m_quality.stepVoxels /= 2.0;
    if (m_isLocal)
      *m_quality.fineness += rungsPerHalving;
    return (!m_isEqual || m_quality.stepVoxels >= m_smallestStep) &&
           (!m_isLocal || *m_quality.fineness <= Fineness::most);
  }

  double stepVoxels() const { return m_isLocal ? stepOfRung(*m_quality.fineness) : m_quality.stepVoxels; }

private:
  Quality m_quality;
  bool m_isLocal;
  bool m_isEqual;
  double m_smallestStep;
};

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
