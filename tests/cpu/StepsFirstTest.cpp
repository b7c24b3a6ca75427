// SPDX-License-Identifier: GPL-3.0-or-later
// Equal steps first and cells only where those tell that they are too few: as exact as cells alone with the
// same fineness, whatever the curve, the model and the projection. Judged by pictures found cell by cell with
// a fineness whose own error is far below what is asked (CellBadCasesTest holds those against equal steps).
#include "accuracy/ImageError.h"
#include "cpu/CpuRenderer.h"
#include "scene/light/Shading.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/Heads.h"
#include "support/NeedleScene.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 stepsPicture{160, 140};
constexpr double exactFineness = 12.0;

Scene withFineness(Scene scene, double fineness) {
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = fineness;
  return scene;
}

// The errors of both ways, 99.9th percentile of the picture in levels.
struct Errors {
  double cells, steps;
};

Errors errorsOf(const Scene& scene, double fineness, const glm::ivec2& size = stepsPicture) {
  CpuRenderer cells(0), steps(0, CpuRenderer::Tolerance::stepsFirst);
  const Image exact = cells.render(withFineness(scene, exactFineness), size);
  return {imageError(cells.render(withFineness(scene, fineness), size), exact).p99_9,
          imageError(steps.render(withFineness(scene, fineness), size), exact).p99_9};
}

// Fineness 4 is to err by about a level, and each more by half (scene/steps/CellRule.h); few pixels scatter
// about their percentile by a fifth and more (accuracy/Tolerance.cpp), so that twice is allowed, or half more
// than cells alone.
void expectFineEnough(const Scene& scene, const std::string& what) {
  for (const double fineness : {2.0, 4.0, 6.0}) {
    const Errors errors = errorsOf(scene, fineness);
    std::cout << what << ", fineness " << fineness << ": " << errors.steps << " levels, cells "
              << errors.cells << "\n";
    EXPECT_LE(errors.steps, std::max(2.0 * std::exp2(4.0 - fineness), 1.5 * errors.cells))
        << what << fineness;
  }
}

TEST(StepsFirst, errAsMuchAsTheFinenessSays) {
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::robust}) {
    Scene scene = test::noisyPhantom(model);
    const std::string name = nameOf(model);
    expectFineEnough(scene, name);
    scene.projection = Projection::compositeIsosurface;
    expectFineEnough(scene, name + ", hybrid");
    scene.projection = Projection::composite;
    scene.keep = cubesRegion(scene.volume->grid().dims, 11, {0.0, 1.0, 0.0, 0.3});
    expectFineEnough(scene, name + ", region");
  }
}

TEST(StepsFirst, ofHeadsAsWell) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced})
    expectFineEnough(test::headScene(test::ctHead(), model), std::string("CT head, ") + nameOf(model));
}

// What no sample meets is found by the segments that the scalars ran through.
TEST(StepsFirst, meetNeedlesNarrowerThanAStep) {
  CpuRenderer renderer(0, CpuRenderer::Tolerance::stepsFirst);
  for (const double width : {0.3, 0.1, 1e-2, 1e-3}) {
    test::NeedleScene needle = test::needleScene(width);
    // Unlit pictures go by cells alone.
    needle.scene.shading.model = ShadingModel::classic;
    needle.scene = withFineness(needle.scene, 6.0);
    // A quarter of a level, as fineness 6 says.
    EXPECT_NEAR(renderer.render(needle.scene, {1, 1}).at(0, 0).a, needle.alpha, 0.25 / 255.0) << width;
  }
}

} // namespace
} // namespace limn
