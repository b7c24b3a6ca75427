// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/StableMath.h"
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

#include <cmath>
#include <numbers>

namespace limn {
namespace {

// Opacity 1 over the unit distance is limited to 1 - 2⁻²⁴; over f unit distances that is 1 - 2^(-24 f).
std::vector<Finding> opaque(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [name, length] : {std::pair{"1e-6", 1e-6}, {"0.01", 0.01}, {"1", 1.0}, {"100", 100.0}})
    findings += inEachEngine(
        bench, "a path of " + std::string(name) + " unit distances", {1e-12, 2e-6, 2e-6},
        "alpha against 1 - 2^(-24 f); one rounding of float per step", [length = length](const Draw& draw) {
          Scene scene = rayThrough(boxOf(glm::dvec3(length)));
          scene.transferFunction = constantFunction(1.0, glm::dvec3(1.0));
          return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-24.0 * length * std::numbers::ln2));
        });
  findings.push_back(atMost("cpp", "opacity 1 over no distance",
                            std::abs(oneMinusExpNeg(0.0 * minusLog1mOpacity(1.0))), 0.0,
                            "exactly nothing, not 0 times infinity"));
  return findings;
}

// 1e-4 per unit distance over 5000 of them in steps of a tenth: 1 - (1 - 1e-4)^5000.
std::vector<Finding> faint(Workbench& bench) {
  const auto figure = [](const Draw& draw) {
    Scene scene = rayThrough(boxOf(glm::dvec3(5000.0)));
    scene.transferFunction = constantFunction(1e-4, glm::dvec3(1.0));
    scene.quality.stepVoxels = 0.1 / 5000.0;
    return largestAlphaError(draw(scene, {1, 1}), -std::expm1(5000.0 * std::log1p(-1e-4)));
  };
  std::vector<Finding> findings = inEngines(
      bench, {Engine::reference, Engine::gl, Engine::cpu}, "50000 steps of 1e-5 each", {1e-12, 1e-4, 0.0},
      "alpha against 1 - (1 - 1e-4)^5000; 50000 roundings of half an ulp of what is left, all one "
      "way at worst: 50000 · 2^-25 · 0.07",
      figure);
  findings +=
      inEngines(bench, {Engine::slices}, "50000 slices of 1e-5 each", {0.0, 0.0, 50000.0 / 4194304.0},
                "alpha against 1 - (1 - 1e-4)^5000; blending rounds each layer by up to 2^-22", figure);
  return findings;
}

} // namespace

std::vector<HardCase> opacityCases() {
  return {{"H4", "Full opacity is corrected for any step without infinities", opaque},
          {"H5", "Tiny opacities are neither skipped nor lost", faint}};
}

} // namespace limn
