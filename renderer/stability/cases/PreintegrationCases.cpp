// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/StableMath.h"
#include "scene/function/MeanMaterial.h"
#include "stability/GlslEvaluator.h"
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

#include <cmath>
#include <random>

namespace limn {
namespace {

// The value runs from 0 to 1 over 1 mm, in `samples` exact steps.
Scene ramp(double samples) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  scene.crop.lower.y = 0.25;
  scene.crop.upper.y = 0.75;
  scene.quality.stepVoxels = 1.0 / samples;
  scene.quality.preintegrated = Preintegration::always;
  return scene;
}

// A plateau of width w around 1/2 whose depth along the ramp is 0.7.
constexpr double spikeDepth = 0.7;

double spikeError(const Draw& draw, Scene scene, double width) {
  const double low = 0.5 - 0.5 * width, high = 0.5 + 0.5 * width, extinction = spikeDepth / width;
  scene.transferFunction = {smallUnitMm,
                            {extinctionPoint(low, 0.0, white), extinctionPoint(low, extinction, white),
                             extinctionPoint(high, extinction, white), extinctionPoint(high, 0.0, white)}};
  return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-spikeDepth));
}

double unaskedSpikeError(const Draw& draw, double unitMm) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 100.0));
  scene.crop = ramp(1.0).crop;
  scene.quality.preintegrated = Preintegration::automatic;
  const double opacity = -std::expm1(-7.0 * unitMm);
  scene.transferFunction = {
      unitMm,
      {{0.4995, white, 0.0}, {0.4995, white, opacity}, {0.5005, white, opacity}, {0.5005, white, 0.0}}};
  return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-spikeDepth));
}

std::vector<Finding> spikes(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [what, width] : {std::pair{"a spike of 1/20 of the range", 0.05},
                                    {"a spike of 1/256", 1.0 / 256.0},
                                    {"a spike of 1/1000", 1e-3},
                                    {"a spike of 1/100000", 1e-5}}) {
    // At either edge of the spike the value is off by three roundings of coordinates over four texels and one
    // of its own, 3.5 · 2⁻²⁴, and so is the edge by half of 2⁻²⁴: so much of the width.
    const double edges = spikeDepth * std::exp(-spikeDepth) * 8.0 * 0x1p-24 / width;
    findings += inEachEngine(bench, what, {1e-9, 2e-6 + edges, 2e-6 + edges},
                             "alpha against 1 - exp(-0.7) in 1 to 1000 exact steps; floats round the spike's "
                             "edges and the values at the ends of steps",
                             [width = width](const Draw& draw) {
                               double largest = 0.0;
                               for (const double samples : {1.0, 2.0, 3.0, 7.0, 64.0, 1000.0})
                                 largest = std::max(largest, spikeError(draw, ramp(samples), width));
                               return largest;
                             });
  }
  // 100 mm long, over 1 mm the spike has opacity 0.9991; or over 1e-9 mm one of 7e-9.
  for (const auto& [what, unit] : {std::pair{"a spike of 1/1000, steps chosen by the program", 1.0},
                                   {"the same of a tiny unit distance", smallUnitMm}})
    findings += inEachEngine(bench, what, {1e-9, 2e-4, 2e-4},
                             "alpha against 1 - exp(-0.7): samples half a voxel apart would miss it, so "
                             "steps must become exact of themselves",
                             [unit = unit](const Draw& draw) { return unaskedSpikeError(draw, unit); });
  return findings;
}

// Opacity rises from 0 to 0.8 and falls to 0.2.
TransferFunction twoFlanks() {
  return {1.0, {{0.0, {0.1, 0.2, 0.3}, 0.0}, {0.5, {0.9, 0.5, 0.1}, 0.8}, {1.0, {0.2, 0.9, 0.4}, 0.2}}};
}

// The mean of -log(1-a) over opacities from a to b: ((1-a) log(1-a) + a) is the integral from 0 on. Where the
// two nearly agree, the value in the middle and the curvature there.
double meanExtinction(double a, double b) {
  const auto integral = [](double x) { return (1.0 - x) * std::log1p(-x) + x; };
  if (std::abs(b - a) > 1e-4)
    return (integral(b) - integral(a)) / (b - a);
  const double middle = 0.5 * (a + b);
  return -std::log1p(-middle) + (b - a) * (b - a) / (24.0 * (1.0 - middle) * (1.0 - middle));
}

// Pairs of values that both lie on one flank, nearer and nearer to each other.
std::vector<glm::vec4> nearPairs() {
  std::vector<glm::vec4> pairs;
  for (const float from : {0.001f, 0.11f, 0.3f, 0.49f, 0.55f, 0.77f, 0.9f})
    for (const float apart : {0.0f, 1e-7f, 1e-6f, 1e-5f, 1e-4f, 1e-3f, 1e-2f}) {
      pairs.push_back({from, from + apart, 0.0f, 0.0f});
      pairs.push_back({from + apart, from, 0.0f, 0.0f});
    }
  return pairs;
}

std::vector<Finding> equalEnds(Workbench& bench) {
  const TransferFunction function = twoFlanks();
  Scene scene = ramp(2.0);
  scene.transferFunction = function;
  const std::vector<glm::vec4> pairs = nearPairs();
  const auto worst = [&](const auto& extinctionOf) {
    double largest = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const double expected =
          meanExtinction(classify(function, pairs[i].x).opacity, classify(function, pairs[i].y).opacity);
      largest = std::max(largest, finiteOrInfinite(std::abs(oneMinusExpNeg(0.5 * extinctionOf(i)) -
                                                            oneMinusExpNeg(0.5 * expected))));
    }
    return largest;
  };
  const auto inCpp = [&](std::size_t i) { return meanMaterial(function, pairs[i].x, pairs[i].y).extinction; };
  const std::string what = "steps between nearly equal values";
  const std::string reason = "alpha of half a unit distance between two values 0 to 0.01 apart, against the "
                             "integral's closed form: nothing is divided by their difference";
  std::vector<Finding> findings = {
      atMost("cpp", what, worst(inCpp), 1e-12, reason), withOpenGl(bench, "glsl", what, [&] {
        const std::vector<glm::vec4> means =
            GlslEvaluator({"stable_math.glsl", "piecewise.glsl", "classification.glsl",
                           "preintegration.glsl"})("meanMaterial(v.x, v.y).extinction", pairs, scene);
        return atMost("glsl", what, worst([&](std::size_t i) { return double(means[i].r); }), 2e-6, reason);
      })};
  findings +=
      inEachEngine(bench, "a constant volume in exact steps", {1e-12, 1e-6, 1e-6},
                   "alpha of extinction 0.7 over half a mm against 1 - exp(-0.35)", [](const Draw& draw) {
                     Scene flat = rayThrough(boxOf(glm::dvec3(0.5)));
                     flat.transferFunction = constantFunction(-std::expm1(-0.7), white);
                     flat.quality.preintegrated = Preintegration::always;
                     flat.quality.stepVoxels = 0.3;
                     return largestAlphaError(draw(flat, {1, 1}), -std::expm1(-0.35));
                   });
  return findings;
}

// Extinction 10 s and colour s over one step: alpha is 1 - exp(-5), the mean colour, weighted by extinction,
// ∫s·s/∫s = 2/3 of it. Without attenuation within the step the colour would be 3.33.
double steepStepError(const Draw& draw) {
  Scene scene = ramp(1.0);
  scene.transferFunction = {smallUnitMm,
                            {extinctionPoint(0.0, 0.0, glm::dvec3(0.0)), extinctionPoint(1.0, 10.0, white)}};
  const glm::dvec4 pixel = draw(scene, {1, 1}).at(0, 0);
  const double alpha = -std::expm1(-5.0);
  return finiteOrInfinite(std::max(std::abs(pixel.a - alpha), std::abs(pixel.r - alpha * 2.0 / 3.0)));
}

int unsoundLongSteps(const Draw& draw) {
  std::mt19937 generator(37);
  const auto share = [&] { return (generator() % 1001) / 1000.0; };
  int unsound = 0;
  for (int i = 0; i < 12; ++i) {
    Scene scene = wholeVolume(smoothVolume(10), ShadingModel::none, 0.0, 100.0, {0.6, 0.64, 0.48});
    scene.transferFunction.points.clear();
    for (int k = 0; k < 5; ++k)
      scene.transferFunction.points.push_back(
          {25.0 * k, {share(), share(), share()}, k % 2 == 0 ? share() : 1.0});
    scene.transferFunction.unitDistanceMm = 0.1;
    scene.quality.preintegrated = Preintegration::always;
    scene.quality.stepVoxels = 4.0;
    unsound += unsoundPixels(draw(scene, {16, 16}));
  }
  return unsound;
}

std::vector<Finding> attenuation(Workbench& bench) {
  std::vector<Finding> findings = inEachEngine(bench, "one step from extinction 0 to 10", {1e-7, 2e-6, 2e-6},
                                               "alpha against 1 - exp(-5) and colour against 2/3 of it; "
                                               "extinction over 1e-9 mm is linear in the value to 1e-8",
                                               steepStepError);
  findings += inEachEngine(bench, "random steep functions in steps of 4 voxels", {},
                           "pixels with a colour above alpha, or that are not finite or outside 0..1",
                           [](const Draw& draw) { return unsoundLongSteps(draw); });
  return findings;
}

} // namespace

std::vector<HardCase> preintegrationCases() {
  return {{"H25", "Spikes narrower than any table's entry keep their light", spikes},
          {"H36", "Exact steps between equal values divide nothing by nothing", equalEnds},
          {"H37", "Exact steps attenuate their own light: no colour exceeds its alpha", attenuation}};
}

} // namespace limn
