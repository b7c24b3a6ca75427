// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/AnalyticScenes.h"

#include "support/AnalyticCases.h"

#include <cmath>
#include <numbers>

namespace limn::test {
namespace {

using nlohmann::json;

// A1: any number of steps gives the same alpha, because the product of transmittances telescopes.
std::vector<AnalyticRay> slabs(const json& one) {
  const json& p = one["parameters"];
  const double tau = p["tau"], length = p["D"], grey = p["c"];
  // tau·u ≤ 1/2 keeps the opacity below its limit.
  const double unit = 0.5 / std::max(tau, 0.5);
  std::vector<AnalyticRay> rays;
  for (const double samples : {1.0, 2.0, 3.0, 7.0, 16.0, 100.0, 1000.0, 9999.0}) {
    Scene scene = rayThrough(boxOf({1.0, length, 1.0}));
    scene.transferFunction = constantFunction(-std::expm1(-tau * unit), glm::dvec3(grey), unit);
    scene.quality.stepVoxels = stepFor(scene, length, samples);
    rays.push_back(rayOf(one, "N=" + std::to_string(int(samples)), scene));
    rays.back().alpha = expectedOf(one, "alpha");
    rays.back().color = glm::dvec3(grey * expectedOf(one, "alpha"));
  }
  return rays;
}

// A2, A7: a slab wide enough that a ray at the angle leaves through its far face.
AnalyticRay obliqueSlab(const json& one, double tau, double thickness, double degrees, const char* key) {
  const double angle = degrees * std::numbers::pi / 180.0;
  Scene scene = rayThrough(boxOf({100.0 * thickness, thickness, 100.0 * thickness}),
                           {std::sin(angle), std::cos(angle), 0.0});
  scene.transferFunction = constantFunction(-std::expm1(-tau), glm::dvec3(1.0));
  scene.quality.stepVoxels = 0.1;
  AnalyticRay ray = rayOf(one, key + std::string(" at ") + std::to_string(degrees), scene);
  ray.alpha = expectedOf(one, key);
  return ray;
}

// A7: every pixel of a perspective picture has its own path. The third pixel of a row of three lies two half
// heights from the axis.
std::vector<AnalyticRay> perspectiveSlab(const json& one) {
  const double thickness = one["parameters"]["D_over_dref"];
  const double angle = one["parameters"]["theta_deg"].get<double>() * std::numbers::pi / 180.0;
  Scene scene = rayThrough(boxOf({100.0 * thickness, thickness, 100.0 * thickness}));
  scene.camera.projection = Camera::Projection::perspective;
  scene.camera.position = {0.0, -2.0 * thickness, 0.0};
  scene.camera.fovYDeg = 2.0 * std::atan(std::tan(angle) / 2.0) * 180.0 / std::numbers::pi;
  scene.transferFunction = constantFunction(one["parameters"]["a0"], glm::dvec3(1.0));
  scene.quality.stepVoxels = 0.1;
  std::vector<AnalyticRay> rays(3, rayOf(one, "in perspective, pixel ", scene));
  for (std::size_t pixel = 0; pixel < rays.size(); ++pixel) {
    rays[pixel].what += std::to_string(pixel);
    rays[pixel].size = {3, 1};
    rays[pixel].pixel = pixel;
    rays[pixel].alpha = expectedOf(one, pixel == 1 ? "alpha_axis" : "alpha_35deg");
  }
  return rays;
}

AnalyticRay anisotropicBox(const json& one) {
  const json& p = one["parameters"];
  Grid grid;
  for (int axis = 0; axis < 3; ++axis) {
    grid.dims[axis] = p["dims"][static_cast<std::size_t>(axis)];
    grid.spacingMm[axis] = p["spacing_mm"][static_cast<std::size_t>(axis)];
  }
  grid.originMm = -0.5 * grid.spacingMm * (glm::dvec3(grid.dims) - 1.0);
  const auto voxels = static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z;
  const auto volume = std::make_shared<const Volume>(grid, std::vector<float>(voxels, 7.0f), Rescale{},
                                                     std::nullopt, VolumeInfo{});
  glm::dvec3 direction(0.0);
  direction[p["axis"].get<std::string>()[0] - 'x'] = 1.0;
  Scene scene = rayThrough(volume, direction);
  scene.transferFunction = constantFunction(-std::expm1(-p["tau_per_mm"].get<double>()), glm::dvec3(1.0));
  AnalyticRay ray = rayOf(one, "", scene);
  ray.alpha = expectedOf(one, "alpha");
  return ray;
}

// A4, A6: an opacity over the unit distance of 1 mm, through n of them, for several steps.
std::vector<AnalyticRay> corrected(const json& one, double opacity, double length,
                                   std::initializer_list<double> steps, const char* key) {
  std::vector<AnalyticRay> rays;
  for (const double step : steps) {
    Scene scene = rayThrough(boxOf({length, length, length}));
    scene.transferFunction = constantFunction(opacity, glm::dvec3(1.0));
    scene.quality.stepVoxels = step / length;
    rays.push_back(rayOf(one, "step " + std::to_string(step), scene));
    rays.back().alpha = expectedOf(one, key);
  }
  return rays;
}

// A8: a ray beside the box gives exactly nothing.
AnalyticRay missedBox(const json& one) {
  Scene scene = rayThrough(boxOf(glm::dvec3(1.0)));
  scene.camera.position.x += 2.0;
  scene.camera.target.x += 2.0;
  scene.transferFunction = constantFunction(0.5, glm::dvec3(1.0));
  AnalyticRay ray = rayOf(one, "beside the box", scene);
  ray.alpha = 0.0;
  ray.color = glm::dvec3(0.0);
  ray.tolerance = ray.glTolerance = 0.0;
  return ray;
}

// A9: opacity 1 is limited to 1 - 2⁻²⁴ and stays finite for paths of any length.
std::vector<AnalyticRay> opaquePaths(const json& one) {
  std::vector<AnalyticRay> rays;
  for (const auto& [key, length] :
       {std::pair{"alpha_f=1", 1.0}, {"alpha_f=0.01", 0.01}, {"alpha_f=1e-6", 1e-6}}) {
    Scene scene = rayThrough(boxOf(glm::dvec3(length)));
    scene.transferFunction = constantFunction(1.0, glm::dvec3(1.0));
    rays.push_back(rayOf(one, key, scene));
    rays.back().alpha = -std::expm1(length * -24.0 * std::numbers::ln2);
    // The file rounds its figures for the shorter paths to five digits and more.
    if (std::abs(*rays.back().alpha - expectedOf(one, key)) > 1e-9)
      throw std::runtime_error("A9: the file's figure is not 1 - 2^(-24 f)");
  }
  return rays;
}

} // namespace

AnalyticRay rayOf(const json& one, std::string what, Scene scene) {
  const json& tolerance = one["tolerance"];
  AnalyticRay ray;
  ray.id = one["id"];
  ray.what = std::move(what);
  ray.scene = std::move(scene);
  ray.tolerance = tolerance.value("cpu_double", 1e-12);
  ray.glTolerance = tolerance.value("gpu_float_target", 2e-6);
  return ray;
}

double expectedOf(const json& one, const char* key) {
  const json& entry = one["expected"][key];
  return entry.is_object() ? entry["value"].get<double>() : entry.get<double>();
}

std::vector<AnalyticRay> homogeneousRays(const json& one) {
  const std::string id = one["id"];
  const json& p = one["parameters"];
  if (id.starts_with("A1_"))
    return slabs(one);
  if (id.starts_with("A2_"))
    return {obliqueSlab(one, p["tau"], p["D"], p["theta_deg"], "alpha")};
  if (id.starts_with("A3_"))
    return {anisotropicBox(one)};
  if (id.starts_with("A4_"))
    return corrected(one, p["a0"], p["n_ref_lengths"], {2.0, 1.0, 0.25, 0.1}, "alpha_total");
  if (id.starts_with("A6_"))
    return corrected(one, 1e-4, p["n_ref"], {0.1}, "alpha");
  if (id.starts_with("A7_")) {
    const double tau = -std::log1p(-p["a0"].get<double>());
    std::vector<AnalyticRay> rays = perspectiveSlab(one);
    rays.push_back(obliqueSlab(one, tau, p["D_over_dref"], 0.0, "alpha_axis"));
    rays.push_back(obliqueSlab(one, tau, p["D_over_dref"], p["theta_deg"], "alpha_35deg"));
    return rays;
  }
  if (id.starts_with("A8_"))
    return {missedBox(one)};
  if (id.starts_with("A9_"))
    return opaquePaths(one);
  return {};
}

std::vector<AnalyticRay> analyticRays(const json& cases) {
  std::vector<AnalyticRay> rays;
  for (const json& one : cases) {
    if (!isOfKind(one, "render"))
      continue;
    for (const auto& group :
         {homogeneousRays, rampRays, layerRays, shadingRays, projectionRays, preintegratedRays})
      for (AnalyticRay& ray : group(one))
        rays.push_back(std::move(ray));
  }
  return rays;
}

} // namespace limn::test
