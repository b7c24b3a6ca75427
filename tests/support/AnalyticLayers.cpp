// SPDX-License-Identifier: GPL-3.0-or-later
// Layers of one voxel each, one sample at each voxel's centre; fog in front of them; early termination in
// them.
#include "support/AnalyticScenes.h"

#include <cmath>

namespace limn::test {
namespace {

using nlohmann::json;

const glm::dvec3 red(1.0, 0.0, 0.0), green(0.0, 1.0, 0.0), blue(0.0, 0.0, 1.0);

// Layer i holds the scalar i, point i its colour and opacity over the voxel's 1 mm.
Scene layers(const std::vector<double>& scalars, const std::vector<ControlPoint>& points, bool isReversed) {
  Scene scene = rayThrough(columnOf(scalars, 1.0), {0.0, isReversed ? -1.0 : 1.0, 0.0});
  scene.transferFunction = {1.0, points};
  scene.quality.stepVoxels = 1.0;
  return scene;
}

std::vector<AnalyticRay> threeLayers(const json& one) {
  const std::vector<ControlPoint> points{{0.0, red, 0.2}, {1.0, green, 0.5}, {2.0, blue, 0.8}};
  AnalyticRay forward = rayOf(one, "forward", layers({0.0, 1.0, 2.0}, points, false));
  forward.alpha = expectedOf(one, "A");
  forward.color = {expectedOf(one, "R"), expectedOf(one, "G"), expectedOf(one, "B")};
  AnalyticRay reversed = rayOf(one, "reversed", layers({0.0, 1.0, 2.0}, points, true));
  reversed.alpha = expectedOf(one, "A");
  reversed.color = {expectedOf(one, "reversed_R"), expectedOf(one, "reversed_G"),
                    expectedOf(one, "reversed_B")};
  return {forward, reversed};
}

// Opacity 1 over a tenth of the layer makes 1 - 2⁻²⁴⁰ of the whole.
std::vector<AnalyticRay> opaqueLayers(const json& one) {
  std::vector<AnalyticRay> rays;
  for (const bool isReversed : {false, true}) {
    Scene scene = layers({0.0, 1.0}, {{0.0, red, 1.0}, {1.0, blue, 1.0}}, isReversed);
    scene.transferFunction.unitDistanceMm = 0.1;
    rays.push_back(rayOf(one, isReversed ? "from behind" : "from the front", scene));
    rays.back().alpha = 1.0;
    rays.back().color = isReversed ? blue : red;
  }
  return rays;
}

Fog fogOf(const json& p, Fog::Mode mode) {
  Fog fog;
  fog.mode = mode;
  fog.color = glm::dvec3(p.value("Cfog", 0.5));
  fog.densityPerMm = p.value("density", 0.35);
  if (mode == Fog::Mode::linear) {
    fog.startMm = p["start"];
    fog.endMm = p["end"];
  }
  return fog;
}

// E1: an opaque sheet too thin to have more than one distance.
std::vector<AnalyticRay> fogFactors(const json& one) {
  const json& p = one["parameters"];
  constexpr double thickness = 1e-15;
  std::vector<AnalyticRay> rays;
  for (const auto& [mode, key] :
       {std::pair{Fog::Mode::linear, "C_linear"}, {Fog::Mode::exp, "C_exp"}, {Fog::Mode::exp2, "C_exp2"}}) {
    Scene scene = rayThrough(boxOf(glm::dvec3(thickness)));
    scene.camera.position.y = -p["z"].get<double>();
    scene.transferFunction = constantFunction(1.0, glm::dvec3(p["Cobj"].get<double>()), 0.01 * thickness);
    scene.fog = fogOf(p, mode);
    rays.push_back(rayOf(one, key, scene));
    rays.back().color = glm::dvec3(expectedOf(one, key));
  }
  return rays;
}

// E2: fog as a homogeneous medium of 3 mm before an opaque object; the scalar passes 1/2 where it begins.
AnalyticRay fogAsMedium(const json& one) {
  const json& p = one["parameters"];
  const double unit = 0.1;
  const double opacity = -std::expm1(-p["density"].get<double>() * unit);
  Scene scene = rayThrough(columnOf({0.0, 0.0, 0.0, 1.0}, 1.0));
  scene.transferFunction = {
      unit,
      {{0.5, glm::dvec3(p["Cfog"].get<double>()), opacity}, {0.5, glm::dvec3(p["Cobj"].get<double>()), 1.0}}};
  scene.quality.stepVoxels = 0.1;
  AnalyticRay ray = rayOf(one, "as a medium", scene);
  ray.color = glm::dvec3(expectedOf(one, "I"));
  return ray;
}

// E3: two translucent layers at 1 and 4 mm with nothing between them.
AnalyticRay fogOnLayers(const json& one) {
  const json& p = one["parameters"];
  const std::vector<ControlPoint> points{{-0.5, white, 0.0},
                                         {0.5, white, 0.0},
                                         {0.5, glm::dvec3(p["c"][0].get<double>()), p["alphas"][0]},
                                         {1.5, glm::dvec3(p["c"][0].get<double>()), p["alphas"][0]},
                                         {1.5, glm::dvec3(p["c"][1].get<double>()), p["alphas"][1]}};
  Scene scene = layers({1.0, 0.0, 0.0, 2.0}, points, false);
  scene.camera.position.y = -2.5;
  scene.fog = fogOf({{"density", 0.35}, {"Cfog", p["Cfog"]}}, Fog::Mode::exp);
  AnalyticRay ray = rayOf(one, "", scene);
  ray.alpha = expectedOf(one, "A");
  ray.color = glm::dvec3(expectedOf(one, "C"));
  return ray;
}

AnalyticRay endedInMedium(const json& one) {
  Scene scene = rayThrough(boxOf(glm::dvec3(100.0)));
  scene.transferFunction = constantFunction(one["parameters"]["alpha_i"], red);
  scene.quality.stepVoxels = 0.01;
  scene.quality.earlyTermination = one["parameters"]["theta"];
  AnalyticRay ray = rayOf(one, "", scene);
  ray.alpha = expectedOf(one, "A_at_stop");
  ray.color = red * expectedOf(one, "A_at_stop");
  return ray;
}

std::vector<AnalyticRay> endedBeforeLayer(const json& one) {
  Scene scene = layers({0.0, 1.0}, {{0.5, red, 0.98}, {0.5, white, 1.0}}, false);
  AnalyticRay whole = rayOf(one, "without early termination", scene);
  whole.color = {expectedOf(one, "true_R"), expectedOf(one, "true_G"), expectedOf(one, "true_G")};
  // The layer behind has opacity 1 - 2⁻²⁴, which its share of 0.02 turns into 1.2e-9.
  whole.tolerance = 0.02 / 16777216.0 * 1.01;
  scene.quality.earlyTermination = one["parameters"]["theta"];
  AnalyticRay ended = rayOf(one, "with early termination", scene);
  ended.alpha = expectedOf(one, "ert_R");
  ended.color = {expectedOf(one, "ert_R"), expectedOf(one, "ert_G"), expectedOf(one, "ert_G")};
  return {whole, ended};
}

// K7: colours are display values; half of white over black is half.
AnalyticRay halfWhite(const json& one) {
  Scene scene = rayThrough(boxOf(glm::dvec3(1.0)));
  scene.transferFunction = constantFunction(0.5, white);
  AnalyticRay ray = rayOf(one, "", scene);
  ray.color = glm::dvec3(expectedOf(one, "encoded_blend"));
  return ray;
}

} // namespace

std::vector<AnalyticRay> layerRays(const json& one) {
  const std::string id = one["id"];
  if (id.starts_with("D1_"))
    return threeLayers(one);
  if (id.starts_with("D3_"))
    return opaqueLayers(one);
  if (id.starts_with("E1_"))
    return fogFactors(one);
  if (id.starts_with("E2_"))
    return {fogAsMedium(one)};
  if (id.starts_with("E3_"))
    return {fogOnLayers(one)};
  if (id.starts_with("I1_"))
    return {endedInMedium(one)};
  if (id.starts_with("I2_"))
    return endedBeforeLayer(one);
  if (id.starts_with("K7_"))
    return {halfWhite(one)};
  return {};
}

} // namespace limn::test
