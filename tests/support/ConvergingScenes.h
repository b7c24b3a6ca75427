// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/AnalyticScenes.h"

#include <string>
#include <vector>

namespace limn::test {

/// A ray whose integrand is smooth, and the premultiplied colour and alpha that finer steps approach.
struct ConvergingRay {
  std::string what; ///< NUMERICS 1.2
  Scene scene;
  double lengthMm = 1.0;
  glm::dvec4 limit{0.0};
  int fewestSamples = 0; ///< from where the rule shows its order
  int mostSamples = 0;
};

/// B1 (k = 8), B6 and N1.
std::vector<ConvergingRay> convergingRays();

/// The ray's scene with a step that makes so many samples.
Scene withSamples(const ConvergingRay& ray, int samples);

/// The largest difference of the four channels.
double largestError(const glm::dvec4& pixel, const glm::dvec4& limit);

} // namespace limn::test
