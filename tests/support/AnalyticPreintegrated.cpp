// SPDX-License-Identifier: GPL-3.0-or-later
// Ramps by pre-integrated steps: the scalar is linear within a step, so the mean extinction is exact for any
// number of steps, however narrow the transfer function.
#include "support/AnalyticScenes.h"

#include <algorithm>

namespace limn::test {
namespace {

using nlohmann::json;

// Every ray of a case that has a whole ramp in it, by one and by a few steps; what is left is alpha.
std::vector<AnalyticRay> inFewSteps(const json& one, const Scene& scene) {
  std::vector<AnalyticRay> rays;
  for (const double samples : {1.0, 2.0, 3.0, 7.0, 64.0, 1000.0}) {
    Scene stepped = scene;
    stepped.quality.stepVoxels = 1.0 / samples;
    stepped.quality.preintegrated = Preintegration::always;
    rays.push_back(rayOf(one, "pre-integrated, N=" + std::to_string(int(samples)), stepped));
    rays.back().alpha = expectedOf(one, one["expected"].contains("alpha") ? "alpha" : "alpha_ramp");
  }
  return rays;
}

} // namespace

std::vector<AnalyticRay> preintegratedRays(const json& one) {
  const std::string id = one["id"];
  if (id.rfind("B1_", 0) != 0 && id.rfind("B2_", 0) != 0 && id.rfind("B3_", 0) != 0 &&
      id.rfind("B4_", 0) != 0)
    return {};
  // The functions differ, the ramp is the same; `rampRays` begins with the whole of it.
  return inFewSteps(one, rampRays(one).front().scene);
}

} // namespace limn::test
