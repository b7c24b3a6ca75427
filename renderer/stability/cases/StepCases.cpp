// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/RayFrame.h"
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

#include <cmath>

namespace limn {
namespace {

constexpr double slabMm = 2.0;
constexpr double slabExtinction = 0.5; // per mm: alpha is 1 - 1/e over the slab

Scene slab(double samples) {
  Scene scene = rayThrough(boxOf(glm::dvec3(slabMm)));
  scene.transferFunction = constantFunction(-std::expm1(-slabExtinction), glm::dvec3(1.0));
  scene.quality.stepVoxels = stepFor(scene, slabMm, samples);
  return scene;
}

double slabError(const Draw& draw, double samples) {
  return largestAlphaError(draw(slab(samples), {1, 1}), -std::expm1(-slabExtinction * slabMm));
}

// Slices blend a layer each, and each rounds by up to 2⁻²².
Bounds boundsFor(double samples, double gl) {
  return {1e-12, gl, gl + samples / 4194304.0};
}

const char* const slabReason =
    "alpha of a homogeneous slab against 1 - 1/e, whatever the number of steps; floats round each step";

std::vector<Finding> tinySteps(Workbench& bench) {
  std::vector<Finding> findings = inEachEngine(bench, "60000 steps", boundsFor(60000, 2e-6), slabReason,
                                               [](const Draw& draw) { return slabError(draw, 60000); });
  findings += inEachEngine(bench, "a million steps asked for", boundsFor(60000, 2e-6), slabReason,
                           [](const Draw& draw) { return slabError(draw, 1e6); });
  const std::string taken = "a million steps asked for: how many are taken";
  findings.push_back(withOpenGl(bench, "gl", taken, [&] {
    return atMost("gl", taken, bench.rays().sampleCounts(slab(1e6), {1, 1}).at(0), mostSamples,
                  "drivers end loops at 65535 without a word, so no ray takes more than 60000");
  }));
  const std::string said = "a million steps asked for: it is said";
  findings.push_back(withOpenGl(bench, "gl", said, [&] {
    bench.rays().render(slab(1e6), {1, 1});
    return atMost("gl", said, bench.rays().limitation().empty() ? 1.0 : 0.0, 0.0,
                  "1 where the picture does not say that its step was limited");
  }));
  return findings;
}

std::vector<Finding> hugeSteps(Workbench& bench) {
  std::vector<Finding> findings;
  for (const auto& [name, share] : {std::pair{"steps of a tenth of the slab", 0.1},
                                    {"steps of  the slab", 1.0},
                                    {"steps of ten times the slab", 10.0},
                                    {"steps of a million times the slab", 1e6}})
    findings += inEachEngine(bench, name, {1e-12, 1e-6, 1e-6}, slabReason,
                             [share = share](const Draw& draw) { return slabError(draw, 1.0 / share); });
  return findings;
}

std::vector<Finding> longSums(Workbench& bench) {
  std::vector<Finding> findings;
  for (const int samples : {1000, 9999})
    findings += inEachEngine(bench, std::to_string(samples) + " steps", boundsFor(samples, 2e-6), slabReason,
                             [samples](const Draw& draw) { return slabError(draw, samples); });
  // A step at the middle of a ramp shows where samples lie: an alpha off by one sample's share.
  findings += inEngines(
      bench, {Engine::reference, Engine::gl, Engine::cpu}, "9999 positions on a ramp with a step",
      {1e-12, 2e-4, 0.0},
      "alpha of the half beyond the step; positions that add up roundings would be off by samples, of which "
      "each is worth 1e-4",
      [](const Draw& draw) {
        Scene scene = rayThrough(columnOf({0.0, 1.0, 2.0, 3.0}, 1.0));
        scene.transferFunction = {1.0, {{1.5, glm::dvec3(1.0), 0.0}, {1.5, glm::dvec3(1.0), 0.5}}};
        scene.quality.stepVoxels = stepFor(scene, 4.0, 9999.0);
        // The sample in the middle lies on the step, to which the upper side belongs.
        return largestAlphaError(draw(scene, {1, 1}), -std::expm1(-5000.0 / 9999.0 * 4.0 * std::log(2.0)));
      });
  return findings;
}

} // namespace

std::vector<HardCase> stepCases() {
  return {{"H6", "Tiny steps lose nothing, and their number is limited and said", tinySteps},
          {"H7", "Steps as long as the volume and longer still cover it exactly", hugeSteps},
          {"H8", "Thousands of samples neither drift nor add up roundings", longSums}};
}

} // namespace limn
