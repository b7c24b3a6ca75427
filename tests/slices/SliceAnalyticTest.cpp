// SPDX-License-Identifier: GPL-3.0-or-later
// The slice renderer against closed forms, in both orders of blending, within the tolerances that the file of
// cases states for floats. A7 is the case made for slices: an opacity per slice must follow the path.
#include "slices/ProxySlabs.h"
#include "slices/SliceRenderer.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"
#include "support/GlTest.h"

#include <iostream>
#include <map>

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

TEST_P(SliceAnalytic, everyCaseMeetsItsClosedForm) {
  LIMN_NEEDS_SHARED(test::analyticCasesFile);
  SliceRenderer renderer(GetParam());
  std::map<std::string, double> worst;
  for (test::AnalyticRay& ray : test::analyticRays(test::analyticCases())) {
    // Rays of slices never end early, nor do they know what they passed; those cases belong to rays.
    const Projection projection = ray.scene.projection;
    if (ray.scene.quality.earlyTermination < 1.0 ||
        (projection != Projection::composite && projection != Projection::xray))
      continue;
    if (ray.glStepVoxels > 0.0)
      ray.scene.quality.stepVoxels = ray.glStepVoxels;
    const glm::dvec4 pixel(renderer.render(ray.scene, {1, 1}).pixels[0]);
    const double tolerance =
        ray.glTolerance + (GetParam() == BlendOrder::backToFront ? roundingOf(ray.scene) : 0.0);
    double& error = worst[ray.id];
    const auto check = [&](double value, double expected, const std::string& channel) {
      EXPECT_NEAR(value, expected, tolerance) << ray.id << " " << ray.what << " " << channel;
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
  for (const char* needed : {"A7_slices_equal_raycast", "D1_three_layers", "D3_opaque_ordering"})
    EXPECT_EQ(worst.count(needed), 1u) << needed;
}

INSTANTIATE_TEST_SUITE_P(BothOrders, SliceAnalytic,
                         ::testing::Values(BlendOrder::backToFront, BlendOrder::frontToBack),
                         [](const auto& order) {
                           return order.param == BlendOrder::backToFront ? "backToFront" : "frontToBack";
                         });

} // namespace
} // namespace limn
