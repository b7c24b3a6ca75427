// SPDX-License-Identifier: GPL-3.0-or-later
// The enhanced model where its numbers are known, and degenerate transfer functions.
#include "support/AnalyticScenes.h"

#include <cmath>
#include <numbers>

namespace limn::test {
namespace {

using nlohmann::json;

AnalyticRay flatVolume(const json& one) {
  const json& p = one["parameters"];
  Scene scene = rayThrough(boxOf(glm::dvec3(p["D_over_dref"].get<double>())));
  scene.transferFunction = constantFunction(p["alpha_ref"], glm::dvec3(1.0));
  scene.shading.model = ShadingModel::enhanced;
  scene.shading.opacityRange = {p["Omin"], 1.0};
  scene.quality.stepVoxels = 0.1;
  AnalyticRay ray = rayOf(one, "", scene);
  ray.alpha = expectedOf(one, "alpha");
  return ray;
}

// F4: the normal points along -y; light and view lie in one plane with it, L at 40° and H at 15° from it, so
// V at -10°. One sample over one unit distance has the opacity O·a itself.
AnalyticRay paperIntensity(const json& one) {
  const json& p = one["parameters"];
  const double degree = std::numbers::pi / 180.0;
  const auto inPlane = [degree](double angle) {
    return glm::dvec3(std::sin(angle * degree), -std::cos(angle * degree), 0.0);
  };
  Grid grid;
  grid.dims = {1, 3, 1};
  grid.spacingMm = {100.0, 1.0, 100.0};
  grid.originMm.y = -1.0;
  const auto volume = std::make_shared<const Volume>(grid, std::vector<double>{0.0, 1.0, 2.0}, Rescale{},
                                                     std::nullopt, VolumeInfo{});
  Scene scene = rayThrough(volume, -inPlane(2.0 * 15.0 - 40.0));
  scene.shading.model = ShadingModel::enhanced;
  scene.shading.lightDirection = -inPlane(40.0);
  scene.shading.ambientIntensity = p["Ia"];
  scene.shading.lightIntensity = p["Id"];
  scene.shading.exponentRange = {5.0, 125.0};
  scene.shading.opacityRange = {0.2, 1.0};
  scene.shading.gradientReference = FixedReference{4.0}; // the gradient is 1/mm everywhere: r = 0.25
  const double path = 3.0 / std::cos(10.0 * degree);
  scene.transferFunction = constantFunction(p["O_original"], glm::dvec3(p["Kd"].get<double>()), path);
  scene.quality.stepVoxels = 4.0;
  AnalyticRay ray = rayOf(one, "", scene);
  ray.alpha = 0.2;
  ray.color = glm::dvec3(expectedOf(one, "I"));
  return ray;
}

std::vector<AnalyticRay> whereOMultiplies(const json& one) {
  const json& p = one["parameters"];
  const double o = p["O"], length = p["m"];
  std::vector<AnalyticRay> rays;
  for (const double step : {2.0, 1.0, 0.5, 0.25, 0.0625}) {
    Scene scene = rayThrough(boxOf(glm::dvec3(length)));
    scene.transferFunction = constantFunction(p["alpha_ref"], glm::dvec3(1.0));
    scene.shading.model = ShadingModel::enhanced;
    scene.shading.opacityRange = {o, o};
    scene.quality.stepVoxels = step / length;
    rays.push_back(rayOf(one, "step " + std::to_string(step), scene));
    rays.back().alpha = expectedOf(one, "A_before");
  }
  return rays;
}

std::vector<AnalyticRay> degenerateFunctions(const json& one) {
  const double opacity = expectedOf(one, "one_point_value");
  struct Row {
    const char* what;
    std::vector<ControlPoint> points;
    double alpha;
  };
  // The voxel's value is 1.
  const Row rows[] = {
      {"no points", {}, 0.0},
      {"one point below", {{0.3, white, opacity}}, opacity},
      {"one point above", {{7.0, white, opacity}}, opacity},
      {"all coincident", {{1.0, white, 0.1}, {1.0, white, 0.2}, {1.0, white, opacity}}, opacity},
      {"coincident above", {{2.0, white, opacity}, {2.0, white, 0.2}}, opacity},
      {"no opacity", {{0.0, white, 0.0}, {2.0, white, 0.0}}, 0.0}};
  std::vector<AnalyticRay> rays;
  for (const Row& row : rows) {
    Scene scene = rayThrough(boxOf(glm::dvec3(1.0)));
    scene.transferFunction = {1.0, row.points};
    rays.push_back(rayOf(one, row.what, scene));
    rays.back().alpha = row.alpha;
    rays.back().color = glm::dvec3(row.alpha);
    if (row.alpha == 0.0)
      rays.back().tolerance = rays.back().glTolerance = 0.0;
  }
  return rays;
}

} // namespace

std::vector<AnalyticRay> shadingRays(const json& one) {
  const std::string id = one["id"];
  if (id.starts_with("F2_"))
    return {flatVolume(one)};
  if (id.starts_with("F4_"))
    return {paperIntensity(one)};
  if (id.starts_with("F5_"))
    return whereOMultiplies(one);
  if (id.starts_with("K4_"))
    return degenerateFunctions(one);
  return {};
}

} // namespace limn::test
