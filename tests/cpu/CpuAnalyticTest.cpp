// SPDX-License-Identifier: GPL-3.0-or-later
// The CPU engine against closed forms, within the tolerances that the file of cases states for floats.
#include "cpu/CpuRenderer.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"
#include "support/CaseLedger.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(CpuAnalytic, everyGridExactCaseMeetsItsClosedForm) {
  const nlohmann::json cases = test::analyticCases();
  CpuRenderer renderer;
  test::CaseLedger ledger;
  for (test::AnalyticRay& ray : test::analyticRays(cases)) {
    if (ray.glStepVoxels > 0.0)
      ray.scene.quality.stepVoxels = ray.glStepVoxels;
    const glm::dvec4 pixel(renderer.render(ray.scene, ray.size).pixels[ray.pixel]);
    if (ray.alpha)
      ledger.expectNear(ray.id, ray.what + " alpha", pixel.a, *ray.alpha, ray.glTolerance);
    for (int channel = 0; ray.color && channel < 3; ++channel)
      ledger.expectNear(ray.id, ray.what + " channel " + std::to_string(channel), pixel[channel],
                        (*ray.color)[channel], ray.glTolerance);
  }
  ledger.expectEvery(cases, [](const nlohmann::json& one) {
    return test::isOfKind(one, "render") && one.value("grid_exact", true) &&
           !one["tolerance"].contains("order_in_voxel_size");
  });
  ledger.print();
}

} // namespace
} // namespace limn
