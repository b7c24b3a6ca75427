// SPDX-License-Identifier: GPL-3.0-or-later
// The GLSL ray caster against closed forms, within the tolerances that the file of cases states for floats.
#include "raycaster/RayCaster.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"
#include "support/GlTest.h"

#include <iostream>
#include <map>

namespace limn {
namespace {

using RayCasterAnalytic = test::GlTest;

TEST_F(RayCasterAnalytic, everyCaseMeetsItsClosedForm) {
  LIMN_NEEDS_SHARED(test::analyticCasesFile);
  RayCaster caster;
  std::map<std::string, double> worst;
  for (test::AnalyticRay& ray : test::analyticRays(test::analyticCases())) {
    if (ray.glStepVoxels > 0.0)
      ray.scene.quality.stepVoxels = ray.glStepVoxels;
    const glm::dvec4 pixel(caster.render(ray.scene, {1, 1}).pixels[0]);
    double& error = worst[ray.id];
    const auto check = [&](double value, double expected, const std::string& channel) {
      EXPECT_NEAR(value, expected, ray.glTolerance) << ray.id << " " << ray.what << " " << channel;
      error = std::max(error, std::abs(value - expected));
    };
    if (ray.alpha)
      check(pixel.a, *ray.alpha, "alpha");
    for (int channel = 0; ray.color && channel < 3; ++channel)
      check(pixel[channel], (*ray.color)[channel], "channel " + std::to_string(channel));
  }
  std::cout << worst.size() << " cases, largest error of each:\n";
  for (const auto& [id, error] : worst)
    std::cout << "  " << id << " " << error << "\n";
  EXPECT_GE(worst.size(), 50u);
}

} // namespace
} // namespace limn
