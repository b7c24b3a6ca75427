// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

#include <cmath>

namespace limn {
namespace {

constexpr double opacityPerMm = 0.3; // over a millimetre

// A column of 1 mm voxels along y, everywhere of one opacity, a label and a weight for each.
Scene columnOfWeights(const std::vector<double>& weights) {
  Scene scene = rayThrough(columnOf(std::vector<double>(weights.size(), 1.0), 1.0));
  scene.transferFunction = constantFunction(opacityPerMm, white);
  const glm::ivec3& dims = scene.volume->grid().dims;
  std::vector<Label> labels;
  std::vector<std::uint8_t> places;
  for (int y = 0; y < dims.y; ++y) {
    labels.push_back({y, "Voxel", white});
    places.push_back(static_cast<std::uint8_t>(y));
  }
  scene.keep = {Region::Kind::labels, "", std::make_shared<const LabelMap>(dims, places, labels), weights};
  scene.quality.stepVoxels = 1.0 / 64.0;
  scene.quality.preintegrated = Preintegration::never;
  return scene;
}

// ∫ -ln(1 - a w) dw over w in 0..1: the depth of the millimetre over which a weight rises from 0 to 1.
double rampDepth() {
  return ((1.0 - opacityPerMm) * std::log1p(-opacityPerMm) + opacityPerMm) / opacityPerMm;
}

// Midpoints of 1/64 mm err by at most κ''/24 h² a millimetre of a ramp, κ'' = (a/(1-a))²; renderers that keep
// 16 bits of a weight by up to 8 of its last places.
std::vector<Finding> shapesOf(Workbench& bench) {
  struct Case {
    const char* what;
    std::vector<double> weights;
    double depth;
  };
  const double full = -std::log1p(-opacityPerMm);
  const Case cases[] = {
      {"all hidden", {0, 0, 0, 0, 0}, 0.0},
      {"every weight a half", {0.5, 0.5, 0.5, 0.5, 0.5}, -5.0 * std::log1p(-0.5 * opacityPerMm)},
      {"one voxel kept", {0, 0, 1, 0, 0}, 2.0 * rampDepth()},
      {"one voxel hidden", {1, 1, 0, 1, 1}, 3.0 * full + 2.0 * rampDepth()},
      {"kept at the border", {1, 0, 0, 0, 0}, 0.5 * full + rampDepth()},
      {"taking turns", {1, 0, 1, 0, 1}, full + 4.0 * rampDepth()},
      {"a volume of one voxel, hidden", {0}, 0.0},
      {"a volume of one voxel, faded", {0.25}, -std::log1p(-0.25 * opacityPerMm)},
  };
  std::vector<Finding> findings;
  for (const Case& one : cases)
    findings += inEachEngine(
        bench, one.what, {1e-5, 3e-5, 3e-5}, "alpha against that of the weights' integral",
        [&](const Draw& draw) {
          return largestAlphaError(draw(columnOfWeights(one.weights), {1, 1}), -std::expm1(-one.depth));
        });
  return findings;
}

} // namespace

std::vector<HardCase> regionCases() {
  return {{"H48", "Kept regions of any shape leave what their weights say", shapesOf}};
}

} // namespace limn
