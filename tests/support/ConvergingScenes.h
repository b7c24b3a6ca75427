// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/AnalyticScenes.h"

#include <string>
#include <vector>

namespace limn::test {

/// A ray, and the premultiplied colour and alpha that finer steps approach.
struct ConvergingRay {
  std::string what; ///< the closed form, or N1
  Scene scene;
  double lengthMm = 1.0;
  std::optional<double> alpha;
  std::optional<glm::dvec3> color;
  std::vector<int> samples; ///< from where the rule shows its order; about twice as many each time
  double order = 2.0;       ///< of the midpoint rule
  double floor = 2e-8;      ///< below which an error shows no order: that of smallUnitMm
  /// In floats alpha is told from 1 to 1e-6 only: false where that hides the order.
  bool showsInFloats = true;
};

/// The rays of a case for which it states an order in the step: B1, B2, B6 and K3.
std::vector<ConvergingRay> convergingRays(const nlohmann::json& one);

/// N1 (HARD_CASES section 6), a wave through a narrow function, which has no closed form.
ConvergingRay convergingWave();

/// The ray's scene with a step that makes so many samples.
Scene withSamples(const ConvergingRay& ray, int samples);

/// The largest difference of the channels of which the ray knows the limit.
double largestError(const ConvergingRay& ray, const glm::dvec4& pixel);

} // namespace limn::test
