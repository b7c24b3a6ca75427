// SPDX-License-Identifier: GPL-3.0-or-later
// The slice renderer against closed forms, in both orders of blending, within the tolerances that the file of
// cases states for floats. A7 is the case made for slices: an opacity per slice must follow the path.
#include "slices/ProxySlabs.h"
#include "slices/SliceRenderer.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"
#include "support/CaseLedger.h"
#include "support/GlTest.h"

#include <set>

namespace limn {
namespace {

// Blending back to front forms 1 - a in the blender, whose rounding of up to 2⁻²⁵ a layer always has the same
// sign in a homogeneous medium. It matters to the one case that has 50,000 layers of opacity 1e-5 (A6).
double roundingOf(const Scene& scene) {
  constexpr double manySlabs = 20000.0;
  const double slabs = slabsWanted(scene, {1, 1});
  return slabs > manySlabs ? slabs * 0x1p-25 : 0.0;
}

class SliceAnalytic : public test::GlTest, public ::testing::WithParamInterface<BlendOrder> {};

// Rays of slices never end early, nor do they know what they passed: other cases belong to rays.
bool isSliceable(const Scene& scene) {
  return scene.quality.earlyTermination == 1.0 &&
         (scene.projection == Projection::composite || scene.projection == Projection::xray);
}

TEST_P(SliceAnalytic, everyGridExactCaseThatSlicesDrawMeetsItsClosedForm) {
  if (isAnotherRasteriser())
    GTEST_SKIP() << "GALLIUM_DRIVER names none that this driver has; it draws with " << rendererName();
  const nlohmann::json cases = test::analyticCases();
  SliceRenderer renderer(GetParam());
  test::CaseLedger ledger;
  std::set<std::string> meant;
  for (test::AnalyticRay& ray : test::analyticRays(cases)) {
    if (!isSliceable(ray.scene))
      continue;
    if (ray.glStepVoxels > 0.0)
      ray.scene.quality.stepVoxels = ray.glStepVoxels;
    meant.insert(ray.id);
    const double tolerance =
        ray.glTolerance + (GetParam() == BlendOrder::backToFront ? roundingOf(ray.scene) : 0.0);
    const glm::dvec4 pixel(renderer.render(ray.scene, ray.size).pixels[ray.pixel]);
    if (ray.alpha)
      ledger.expectNear(ray.id, ray.what + " alpha", pixel.a, *ray.alpha, tolerance);
    for (int channel = 0; ray.color && channel < 3; ++channel)
      ledger.expectNear(ray.id, ray.what + " channel " + std::to_string(channel), pixel[channel],
                        (*ray.color)[channel], tolerance);
  }
  EXPECT_GE(meant.size(), 60u);
  for (const char* needed : {"A7_slices_equal_raycast", "D1_three_layers", "D3_opaque_ordering"})
    EXPECT_EQ(meant.count(needed), 1u) << needed;
  ledger.expectEvery(cases, [&](const nlohmann::json& one) { return meant.contains(one["id"]); });
  ledger.print();
}

INSTANTIATE_TEST_SUITE_P(BothOrders, SliceAnalytic,
                         ::testing::Values(BlendOrder::backToFront, BlendOrder::frontToBack),
                         [](const auto& order) {
                           return order.param == BlendOrder::backToFront ? "backToFront" : "frontToBack";
                         });

} // namespace
} // namespace limn
