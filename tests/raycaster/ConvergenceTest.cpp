// SPDX-License-Identifier: GPL-3.0-or-later
// How fast the reference and the GLSL ray caster approach what they approximate when the step is halved. The
// midpoint rule claims order 2 where the integrand is smooth. Tables are printed; bands are those of
// HARD_CASES section 6, 1.8 to 2.2 over two halvings or more, where the error stands 20 times above the
// renderer's rounding.
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/volume/Phantom.h"
#include "support/AnalyticCases.h"
#include "support/ConvergingScenes.h"
#include "support/GlTest.h"
#include "support/Heads.h"
#include "support/ImageCompare.h"
#include "support/Orders.h"
#include "support/TestData.h"

#include <iomanip>
#include <iostream>

namespace limn {
namespace {

// |float - double| of one pixel under the same discretisation, by HARD_CASES section 6.
constexpr double floatFloor = 1e-6;
constexpr double overFloor = 20.0;

using Convergence = test::GlTest;

void print(const std::string& what, const std::vector<double>& errors) {
  std::cout << std::left << std::setw(58) << what << std::setprecision(3);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    std::cout << "  " << std::setw(9) << errors[i];
    if (i > 0)
      std::cout << "(" << std::log2(errors[i - 1] / errors[i]) << ")";
  }
  std::cout << "\n";
}

void expectOrder(const std::string& what, const std::vector<double>& errors, double floor, double order) {
  print(what, errors);
  // Where the integrand is flat at both ends, the rule is exact from the first number of samples on.
  if (errors.front() < floor) {
    EXPECT_LT(*std::max_element(errors.begin(), errors.end()), floor) << what;
    return;
  }
  const std::vector<double> orders = test::observedOrders(errors, floor);
  EXPECT_GE(orders.size(), 2u) << what << " shows too few halvings above rounding";
  const double band = order == 1.0 ? 0.15 : 0.2;
  for (const double observed : orders) {
    EXPECT_GE(observed, order - band) << what;
    EXPECT_LE(observed, order + band) << what;
  }
}

void compareRay(RayCaster& caster, const test::ConvergingRay& ray, Preintegration preintegrated) {
  std::vector<double> reference, glsl;
  for (const int samples : ray.samples) {
    Scene scene = test::withSamples(ray, samples);
    scene.quality.preintegrated = preintegrated;
    reference.push_back(test::largestError(ray, renderReference(scene, {1, 1}, 1).pixels[0]));
    glsl.push_back(test::largestError(ray, glm::dvec4(caster.render(scene, {1, 1}).pixels[0])));
  }
  const std::string what = ray.what + " from N=" + std::to_string(ray.samples.front());
  expectOrder(what + ", reference", reference, ray.floor, ray.order);
  if (ray.showsInFloats)
    expectOrder(what + ", GLSL", glsl, overFloor * floatFloor, ray.order);
}

TEST_F(Convergence, midpointSamplingShowsTheOrdersThatTheCasesState) {
  std::cout << "largest error of colour and alpha by number of samples (order of the halving)\n";
  RayCaster caster;
  for (const nlohmann::json& one : test::analyticCases())
    for (const test::ConvergingRay& ray : test::convergingRays(one))
      compareRay(caster, ray, Preintegration::never);
  compareRay(caster, test::convergingWave(), Preintegration::never);
}

// The scalar is taken as linear within a step, and the mean colour lies at no particular depth of it: both
// cost O(h²) (HARD_CASES section 6, "mean colour x alpha"). Alpha of the ramps is exact and shows no order.
TEST_F(Convergence, preintegratedStepsAreOfOrderTwo) {
  RayCaster caster;
  for (const nlohmann::json& one : test::analyticCases())
    for (test::ConvergingRay& ray : test::convergingRays(one))
      if (ray.color)
        compareRay(caster, ray, Preintegration::always);
  compareRay(caster, test::convergingWave(), Preintegration::always);
}

// J2: the top of a parabola lies up to half a step from a sample, where it has fallen by 4(h/2)² = h².
TEST_F(Convergence, theLargestSampleMissesATopByOrderTwo) {
  constexpr int places = 32;
  RayCaster caster;
  std::vector<double> reference, glsl;
  for (const int samples : {8, 16, 32, 64}) {
    glm::dvec2 worst(0.0);
    for (int place = 0; place < places; ++place) {
      const double top = 0.5 + (static_cast<double>(place) / places - 0.5) / samples;
      const Scene scene = test::parabolaUnderMip(top, samples);
      const double exact = renderReference(scene, {1, 1}, 1).pixels[0].a;
      worst = glm::max(worst, 1.0 - glm::dvec2(exact, caster.render(scene, {1, 1}).pixels[0].a));
    }
    EXPECT_LE(worst.x, 1.0 / (samples * samples) + 1e-12);
    reference.push_back(worst.x);
    glsl.push_back(worst.y);
  }
  expectOrder("J2, worst of many places, reference", reference, 1e-12, 2.0);
  expectOrder("J2, worst of many places, GLSL", glsl, overFloor * floatFloor, 2.0);
}

// Mean errors in 8-bit levels over the channels of the covered pixels for steps of 1, 1/2, 1/4 and 1/8 voxel,
// against a step of 1/32, whose own error is about a sixteenth of the last.
struct HeadErrors {
  std::vector<double> reference, glsl;
  std::vector<double> apart; ///< GLSL against the reference at the same step
};

constexpr glm::ivec2 headSize{32, 32};

HeadErrors headErrors(RayCaster& caster, const Scene& base, const ReferencePicture& converged) {
  const auto all = [](std::size_t) { return true; };
  Scene scene = base;
  HeadErrors errors;
  for (const double step : {1.0, 0.5, 0.25, 0.125}) {
    scene.quality.stepVoxels = step;
    const ReferencePicture exact = renderReference(scene, headSize);
    const Image drawn = caster.render(scene, headSize);
    errors.reference.push_back(test::differenceOf(toImage(exact), converged, all).mean);
    errors.glsl.push_back(test::differenceOf(drawn, converged, all).mean);
    errors.apart.push_back(test::differenceOf(drawn, exact, all).mean);
  }
  return errors;
}

// The mean error falls at every halving, and at the order to be expected once a step is well inside a voxel.
// - Unlit, the integrand is smooth inside the cells of the grid and bends at their borders and at control
//   points. A bend costs the midpoint rule O(h²): order 2. So it is for enhanced and robust, which weigh a
//   sample by its gradient.
// - Classic light knows a direction only. Across a ridge of the data the normal turns by 180° over a length
//   |g along|/|g' across|, often a small part of a voxel, and a step longer than that sees a jump: between
//   order 1 and 2 at these steps.
void expectHeadOrder(const std::string& what, const std::vector<double>& errors, ShadingModel model) {
  print(what, errors);
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_LT(errors[i], errors[i - 1]) << what;
  const double order = 0.5 * std::log2(errors[1] / errors[3]);
  EXPECT_GE(order, model == ShadingModel::classic ? 1.0 : 1.7) << what;
  EXPECT_LE(order, 2.3) << what;
}

void compareModel(RayCaster& caster, Scene scene, const std::string& what,
                  std::initializer_list<Preintegration> ways) {
  scene.quality.preintegrated = Preintegration::never;
  scene.quality.stepVoxels = 1.0 / 32.0;
  const ReferencePicture converged = renderReference(scene, headSize);
  for (const Preintegration preintegrated : ways) {
    scene.quality.preintegrated = preintegrated;
    const HeadErrors errors = headErrors(caster, scene, converged);
    const std::string name = what + (preintegrated == Preintegration::always ? ", pre-integrated" : "");
    expectHeadOrder(name + ", reference", errors.reference, scene.shading.model);
    expectHeadOrder(name + ", GLSL", errors.glsl, scene.shading.model);
    print(name + ", GLSL from the reference", errors.apart);
    for (std::size_t i = 0; i < errors.apart.size(); ++i)
      EXPECT_LE(overFloor * errors.apart[i], errors.glsl[i]) << name;
  }
}

void compareHead(const std::shared_ptr<const Volume>& volume, const std::string& name) {
  const auto never = Preintegration::never, always = Preintegration::always;
  std::cout << "mean error in 8-bit levels at steps of 1, 1/2, 1/4, 1/8 voxel (order of the halving)\n";
  RayCaster caster;
  const auto scene = [&volume](ShadingModel model) { return test::headScene(volume, model); };
  compareModel(caster, scene(ShadingModel::none), name + ", unlit", {never, always});
  compareModel(caster, scene(ShadingModel::classic), name + ", classic", {never});
  compareModel(caster, scene(ShadingModel::enhanced), name + ", enhanced", {never, always});
  compareModel(caster, scene(ShadingModel::robust), name + ", robust", {never});
}

TEST_F(Convergence, bothRenderersShrinkTowardsTheCtHead) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  compareHead(test::ctHead(), "CT head");
}

TEST_F(Convergence, bothRenderersShrinkTowardsThePhantom) {
  compareHead(phantomVolume({.spacingMm = 3.0}), "phantom");
}

} // namespace
} // namespace limn
