// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/Tolerance.h"
#include "scene/ProjectionFacts.h"
#include "scene/steps/LocalSteps.h"

#include <algorithm>
#include <cmath>

namespace limn {

/// Qualities whose steps halve on the way to the exact picture. Where light is added up they begin with
/// fineness 6, otherwise with a quarter of a voxel or the scene's step, whichever is smaller. Cell by cell,
/// what does not integrate is exact from the first.
class Halvings {
public:
  Halvings(const Quality& quality, Projection projection, StepControl control)
      : m_quality(quality), m_isExact(control == StepControl::cells && !integrates(projection)),
        m_isLocal(control != StepControl::equal && integrates(projection)),
        m_isEqual(!m_isExact && (!m_isLocal || (control == StepControl::local && showsSurface(projection)))) {
    m_quality.earlyTermination = 1.0;
    m_quality.jitter = false;
    m_quality.toleranceLevels.reset();
    m_quality.fineness.reset();
    m_quality.ownWeights = false;
    m_quality.stepVoxels = std::min(firstStep, quality.stepVoxels);
    m_smallestStep = std::min(smallestStep, std::ldexp(m_quality.stepVoxels, -leastHalvings));
    if (m_isLocal || m_isExact) {
      m_quality.toleranceLevels = 1.0; // any: the fineness is what counts
      m_quality.fineness = firstFineness;
    }
  }

  const Quality& quality() const { return m_quality; }

  /// Whether the first of them draws the exact picture.
  bool isExact() const { return m_isExact; }

  // False where the steps cannot be halved any more.
  bool halve() {
    if (m_isExact)
      return false;
    if (m_isEqual)
      m_quality.stepVoxels /= 2.0;
    if (m_isLocal)
      *m_quality.fineness += rungsPerHalving;
    return (!m_isEqual || m_quality.stepVoxels >= m_smallestStep) &&
           (!m_isLocal || *m_quality.fineness <= Fineness::most);
  }

  double stepVoxels() const { return m_isLocal ? stepOfRung(*m_quality.fineness) : m_quality.stepVoxels; }

private:
  static constexpr double firstStep = 0.25;
  static constexpr double smallestStep = 1.0 / 1024.0;
  static constexpr double firstFineness = 6.0;
  static constexpr int leastHalvings = 4; ///< that are tried, however fine the scene's own step

  Quality m_quality;
  bool m_isExact;
  bool m_isLocal;
  bool m_isEqual;
  double m_smallestStep;
};

} // namespace limn
