// SPDX-License-Identifier: GPL-3.0-or-later
// Projections other than the composite. A scalar is read off the picture through the transfer function whose
// opacity is the scalar, a place along the ray through a linear fog that whitens black surfaces.
#include "support/AnalyticScenes.h"

#include <cmath>

namespace limn::test {
namespace {

using nlohmann::json;

// The scalar runs from 0 to 1 over 1 mm between two voxel centres, to which the box is cropped.
Scene ramp(Projection projection, double samples) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  scene.crop.lower.y = 0.25;
  scene.crop.upper.y = 0.75;
  scene.projection = projection;
  scene.quality.stepVoxels = 1.0 / samples;
  scene.transferFunction = {1.0, {{0.0, white, 0.0}, {1.0, white, 1.0}}};
  return scene;
}

// J1: the largest of the samples, half a step short of the far end.
std::vector<AnalyticRay> largestOnRamp(const json& one) {
  const int samples = one["parameters"]["N"];
  AnalyticRay sampled = rayOf(one, "as sampled", ramp(Projection::mip, samples));
  sampled.alpha = expectedOf(one, "midpoint_N64");
  sampled.color = glm::dvec3(*sampled.alpha);
  AnalyticRay exact = rayOf(one, "within half a step", sampled.scene);
  exact.alpha = expectedOf(one, "exact");
  exact.tolerance = exact.glTolerance = 0.5 / samples * (1.0 + 1e-6);
  AnalyticRay smallest = rayOf(one, "smallest", ramp(Projection::minip, samples));
  smallest.alpha = 1.0 - *sampled.alpha;
  return {sampled, exact, smallest};
}

// J2: samples at the centres of the voxels.
std::vector<AnalyticRay> largestOnParabola(const json& one) {
  const Scene scene = parabolaUnderMip(0.437, one["parameters"]["N"]);
  AnalyticRay sampled = rayOf(one, "as sampled", scene);
  sampled.alpha = expectedOf(one, "midpoint");
  AnalyticRay exact = rayOf(one, "within the bound", scene);
  exact.alpha = expectedOf(one, "exact");
  exact.tolerance = exact.glTolerance = expectedOf(one, "bound");
  return {sampled, exact};
}

// J3: the mean, and the opacity of an extinction k s, whose integral is k times the mean.
std::vector<AnalyticRay> meanOfRamp(const json& one) {
  const double mean = expectedOf(one, "mean"), k = 3.0;
  std::vector<AnalyticRay> rays;
  for (const double samples : {1.0, 7.0, 64.0}) {
    rays.push_back(rayOf(one, "average of " + std::to_string(samples), ramp(Projection::average, samples)));
    rays.back().alpha = mean;
    Scene scene = ramp(Projection::xray, samples);
    scene.transferFunction = {smallUnitMm,
                              {extinctionPoint(0.0, 0.0, black), extinctionPoint(1.0, k, black)}};
    rays.push_back(rayOf(one, "X-ray of " + std::to_string(samples), scene));
    rays.back().alpha = -std::expm1(-k * mean);
    rays.back().color = glm::dvec3(*rays.back().alpha);
    // The extinction is linear in the scalar to k·u/2 = 1.5e-9 of itself.
    rays.back().tolerance += 1e-8;
  }
  return rays;
}

// J4: where the ramp reaches the isovalue, at the entry and at the exit too.
std::vector<AnalyticRay> hitOnRamp(const json& one) {
  std::vector<AnalyticRay> rays;
  for (const double samples : {1.0, 7.0, 64.0}) {
    Scene scene = ramp(Projection::isosurface, samples);
    scene.isovalue = one["parameters"]["iso"];
    scene.transferFunction = constantFunction(0.0, black);
    const double entry = -0.5 - scene.camera.position.y;
    scene.fog = distanceFog(entry, entry + 1.0);
    AnalyticRay ray = rayOf(one, "N=" + std::to_string(int(samples)), scene);
    ray.alpha = 1.0;
    ray.color = glm::dvec3(expectedOf(one, "t"));
    ray.glTolerance = ray.tolerance;
    rays.push_back(ray);
  }
  return rays;
}

// The case's f = r is above its isovalue where the ray enters, which is a hit there; -r and -iso are the same
// sphere seen from outside.
RefinedRay refinedSphere(const json& one, const char* what, double expected,
                         const std::function<void(Scene&)>& shown) {
  RefinedRay ray;
  ray.id = one["id"];
  ray.what = what;
  ray.channel = 0;
  ray.expected = expected;
  ray.scene = [b = one["parameters"]["b"].get<double>(), shown](double voxelMm, const glm::dvec3& shift) {
    Scene scene = ballSurface(b, voxelMm, shift);
    shown(scene);
    return scene;
  };
  ray.coarsestMm = 1.0 / 512.0;
  ray.lattices = 64;
  ray.lowestOrder = 1.8;
  ray.highestOrder = 2.2;
  ray.finestLimit = one["tolerance"]["cpu_double"];
  return ray;
}

} // namespace

Scene parabolaUnderMip(double top, int samples) {
  std::vector<double> values;
  for (int i = 0; i < samples; ++i) {
    const double fromTop = (i + 0.5) / samples - top;
    values.push_back(1.0 - 4.0 * fromTop * fromTop);
  }
  Scene scene = rayThrough(columnOf(values, 1.0 / samples));
  scene.projection = Projection::mip;
  scene.quality.stepVoxels = 1.0;
  scene.transferFunction = {1.0, {{0.0, white, 0.0}, {1.0, white, 1.0}}};
  return scene;
}

std::vector<AnalyticRay> projectionRays(const json& one) {
  const std::string id = one["id"];
  if (id.starts_with("J1_"))
    return largestOnRamp(one);
  if (id.starts_with("J2_"))
    return largestOnParabola(one);
  if (id.starts_with("J3_"))
    return meanOfRamp(one);
  if (id.starts_with("J4_"))
    return hitOnRamp(one);
  return {};
}

// J5: the place of the hit, and the cosine that a diffuse headlight shows there.
std::vector<RefinedRay> refinedSurfaces(const json& one) {
  if (!one["id"].get<std::string>().starts_with("J5_"))
    return {};
  const auto place = [](Scene& scene) {
    scene.transferFunction = constantFunction(0.0, black);
    scene.fog = distanceFog(0.0, 1.0);
  };
  const auto cosine = [](Scene& scene) {
    scene.transferFunction = constantFunction(0.0, white);
    scene.shading.model = ShadingModel::classic;
    scene.shading.ambient = scene.shading.specular = 0.0;
    scene.shading.diffuse = scene.shading.lightIntensity = 1.0;
  };
  return {refinedSphere(one, "place", 1.0 + expectedOf(one, "z"), place),
          refinedSphere(one, "N.V", expectedOf(one, "NdotV"), cosine)};
}

} // namespace limn::test
