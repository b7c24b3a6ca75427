// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the estimate of a picture's error, made from pictures of the same scene with other steps, can be
// trusted: picture-wide it must never fall below half of the true 99.9th percentile. The truth is the closed
// form, or the reference in double precision, without early termination, at a far smaller step. Tables are
// printed.
#include "accuracy/ErrorEstimate.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "support/AnalyticCases.h"
#include "support/ConvergingScenes.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/TestData.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace limn {
namespace {

using Estimate = test::GlTest;

PrecisePixels oneExactPixel(const test::ConvergingRay& ray, const glm::dvec4& finest) {
  return {{ray.color.value_or(glm::dvec3(finest)), ray.alpha.value_or(finest.a)}};
}

// What a renderer in floats is off by anyway (HARD_CASES section 6: 1e-6 of the range), in levels.
constexpr double roundingLevels = 255e-6;

// Draws one ray with more and more samples, as refinement does.
template <class Draw>
void expectHonestRay(const char* renderer, const test::ConvergingRay& ray, Draw&& draw) {
  const glm::dvec4 finest = renderReference(test::withSamples(ray, 16384), {1, 1}, 1).pixels[0];
  const PrecisePixels exact = oneExactPixel(ray, finest);
  std::vector<ImageError> halvings;
  PrecisePixels coarser;
  for (int samples = 32; samples <= 1024; samples *= 2) {
    const PrecisePixels pixels = draw(test::withSamples(ray, samples));
    if (!coarser.empty()) {
      halvings.push_back(imageError(pixels, coarser));
      const ErrorEstimate estimate = errorAfterHalvings(halvings);
      const double truth = imageError(pixels, exact).p99_9;
      if (samples >= 64) {
        std::printf("%-9s %-40s N=%-5d true %10.6f estimate %10.6f order %.2f\n", renderer, ray.what.c_str(),
                    samples, truth, estimate.p99_9, estimate.order);
        EXPECT_GE(estimate.p99_9, 0.5 * truth - roundingLevels) << ray.what << " N=" << samples;
      }
    }
    coarser = pixels;
  }
}

void expectHonest(RayCaster& caster, const test::ConvergingRay& ray) {
  expectHonestRay("reference", ray, [](const Scene& scene) {
    return renderReference(scene, {1, 1}, 1).pixels;
  });
  expectHonestRay("GLSL", ray, [&](const Scene& scene) { return precise(caster.render(scene, {1, 1})); });
}

TEST_F(Estimate, isNeverBelowHalfOfTheTruthOnSmoothRays) {
  RayCaster caster;
  int rays = 0;
  for (const nlohmann::json& one : test::analyticCases()) {
    const std::string id = one["id"];
    if (!id.starts_with("B1_") && !id.starts_with("B6_"))
      continue;
    for (const test::ConvergingRay& ray : test::convergingRays(one)) {
      expectHonest(caster, ray);
      ++rays;
    }
  }
  EXPECT_GE(rays, 2);
  expectHonest(caster, test::convergingWave());
}

constexpr glm::ivec2 headSize{96, 96};
// The longer side of the small pictures by which moving pictures are judged (widgets/view/ErrorProbe).
constexpr glm::ivec2 smallSize{64, 64};

Image drawn(RayCaster& caster, Scene scene, double step, const glm::ivec2& size) {
  scene.quality.stepVoxels = step;
  return caster.render(scene, size);
}

// The estimate of a picture from small ones of its step, its half and its quarter.
ErrorEstimate fromSmallPictures(RayCaster& caster, const Scene& scene, double step) {
  const Image shown = drawn(caster, scene, step, smallSize);
  const Image half = drawn(caster, scene, step / 2.0, smallSize);
  const Image quarter = drawn(caster, scene, step / 4.0, smallSize);
  const ImageError first = imageError(half, shown);
  const ImageError second = imageError(quarter, half);
  return withEarlyEnds(errorBeforeHalvings(first, second), errorOfEarlyEnds(shown, scene));
}

void expectHonestHead(RayCaster& caster, Scene scene, const PrecisePixels& truth, const std::string& what) {
  std::printf("%s, early termination at %g\n", what.c_str(), scene.quality.earlyTermination);
  std::vector<ImageError> halvings;
  Image coarser = drawn(caster, scene, 1.0, headSize);
  for (const double step : {1.0 / 2, 1.0 / 4, 1.0 / 8, 1.0 / 16}) {
    const Image image = drawn(caster, scene, step, headSize);
    halvings.push_back(imageError(image, coarser));
    const ErrorEstimate estimate =
        withEarlyEnds(errorAfterHalvings(halvings), errorOfEarlyEnds(image, scene));
    const ErrorEstimate small = fromSmallPictures(caster, scene, step);
    const double real = imageError(image, truth).p99_9;
    std::printf("  step 1/%-3g true %7.3f  refinement %7.3f (x %.2f)  small pictures %7.3f (x %.2f)\n",
                1.0 / step, real, estimate.p99_9, estimate.p99_9 / real, small.p99_9, small.p99_9 / real);
    EXPECT_GE(estimate.p99_9, 0.5 * real) << what << " step " << step;
    EXPECT_GE(small.p99_9, 0.5 * real) << what << " step " << step << ", small pictures";
    coarser = image;
  }
}

TEST_F(Estimate, isNeverBelowHalfOfTheTruthOnTheCtHead) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  RayCaster caster;
  const auto volume = test::ctHead();
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced})
    for (const bool isBone : {false, true}) {
      const std::string what = std::string(model == ShadingModel::classic ? "classic" : "enhanced") +
                               (isBone ? ", bone" : ", skin, muscle and bone");
      Scene scene = test::headScene(volume, model);
      // From here an estimate by the last order alone fell to 0.4 of the truth.
      scene.camera = orbited(scene.camera, 1.4, 0.4);
      if (isBone)
        scene.transferFunction = test::boneOnly();
      scene.quality.stepVoxels = 1.0 / 64.0;
      const PrecisePixels truth = renderReference(scene, headSize).pixels;
      expectHonestHead(caster, scene, truth, what);
      scene.quality.earlyTermination = 0.998;
      expectHonestHead(caster, scene, truth, what);
    }
}

} // namespace
} // namespace limn
