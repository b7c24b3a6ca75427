// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/RayFrame.h"
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

#include <cmath>

namespace limn {
namespace {

// The value runs from 0 to 1 over 1 mm in 16 steps, alike in all 8 x 8 pixels; extinction k s per mm. Samples
// at the part u of their steps have the depth k/2 + k h (u - 1/2).
constexpr double slope = 8.0;
constexpr double stepLength = 1.0 / 16.0;

Scene ramp(bool isJittered) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  scene.crop.lower.y = 0.25;
  scene.crop.upper.y = 0.75;
  scene.transferFunction = {smallUnitMm,
                            {extinctionPoint(0.0, 0.0, white), extinctionPoint(1.0, slope, white)}};
  scene.quality.stepVoxels = stepLength;
  scene.quality.jitter = isJittered;
  return scene;
}

double meanAlpha(const DrawnPicture& picture) {
  double sum = 0.0;
  for (const glm::dvec4& pixel : picture.pixels)
    sum += pixel.a;
  return sum / static_cast<double>(picture.pixels.size());
}

std::vector<Finding> jitter(Workbench& bench) {
  const double halfStep = 0.5 * slope * stepLength;
  const double middle = std::exp(-0.5 * slope);
  std::vector<Finding> findings =
      inEachEngine(bench, "switched off", {},
                   "difference of two pictures with another drawn between them: none", [](const Draw& draw) {
                     Scene scene = wholeVolume(smoothVolume(12), ShadingModel::classic, 0.0, 100.0);
                     const DrawnPicture first = draw(scene, {24, 24});
                     scene.quality.jitter = true;
                     draw(scene, {24, 24});
                     scene.quality.jitter = false;
                     return largestDifference(first, draw(scene, {24, 24}));
                   });
  const double bias = middle * (std::sinh(halfStep) / halfStep - 1.0) + 2e-6;
  findings += inEachEngine(bench, "mean of the jittered pixels", {bias, bias, bias},
                           "distance from the exact alpha 1 - exp(-k/2): e^-x over a step exceeds its middle "
                           "by the factor sinh(w)/w, w = k h/2, whatever the number of pixels",
                           [middle](const Draw& draw) {
                             return std::abs(meanAlpha(draw(ramp(true), {8, 8})) - (1.0 - middle));
                           });
  const double noise = middle * std::expm1(halfStep) + 2e-6;
  findings += inEachEngine(bench, "each jittered pixel", {noise, noise, noise},
                           "largest distance from the exact alpha: half a step of the steepest place",
                           [middle](const Draw& draw) {
                             return largestAlphaError(draw(ramp(true), {8, 8}), 1.0 - middle);
                           });
  return findings;
}

Scene opaqueScene(double earlyTermination) {
  Scene scene = wholeVolume(smoothVolume(16), ShadingModel::classic, 0.0, 100.0, {0.6, 0.64, 0.48});
  scene.transferFunction.unitDistanceMm = 1.0;
  scene.quality.earlyTermination = earlyTermination;
  return scene;
}

std::vector<Finding> earlyTermination(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [what, e] : {std::pair{"ending at 0.5", 0.5},
                                {"ending at 0.98, the paper's", 0.98},
                                {"ending at 1 - 1/255", 1.0 - 1.0 / 255.0},
                                {"ending at 0.998, the program's", 0.998}}) {
    // What is left of the light where a ray ends, and what floats round of the rest.
    const double left = lastTransmittance(e) + 1e-6;
    findings += inEachEngine(
        bench, what, {left, left, 0.0},
        "largest difference from rays that never end: at most what was left of the light; slices never end "
        "and must not differ at all",
        [e = e](const Draw& draw) {
          return largestDifference(draw(opaqueScene(e), {32, 32}), draw(opaqueScene(1.0), {32, 32}));
        });
  }
  for (const auto& [what, projection] : {std::pair{"an X-ray", Projection::xray},
                                         {"a maximum", Projection::mip},
                                         {"a minimum", Projection::minip},
                                         {"an average", Projection::average}})
    findings += inEachEngine(bench, what, {},
                             "largest difference that ending at 0.5 makes: none, every sample counts",
                             [projection = projection](const Draw& draw) {
                               const auto at = [&](double e) {
                                 Scene scene = opaqueScene(e);
                                 scene.projection = projection;
                                 return draw(scene, {32, 32});
                               };
                               return largestDifference(at(0.5), at(1.0));
                             });
  return findings;
}

} // namespace

std::vector<HardCase> samplingCases() {
  return {{"H31", "Jitter is off without a trace, and on it only spreads the error of a step", jitter},
          {"H32", "Rays that end early lose no more than what was left of the light", earlyTermination}};
}

} // namespace limn
