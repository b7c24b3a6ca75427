// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/ConvergingScenes.h"

#include "reference/ReferenceIntegrator.h"

#include <cmath>
#include <numbers>

namespace limn::test {
namespace {

const glm::dvec3 white(1.0);

// The scalar runs from 0 to 1 along 1 mm between two voxel centres; extinction 8 s, colour s.
ConvergingRay ramp() {
  ConvergingRay ray;
  ray.what = "B1, s = t, extinction 8 s, colour s";
  ray.scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  ray.scene.crop.lower.y = 0.25;
  ray.scene.crop.upper.y = 0.75;
  ray.scene.transferFunction = {
      smallUnitMm, {extinctionPoint(0.0, 0.0, glm::dvec3(0.0)), extinctionPoint(1.0, 8.0, white)}};
  // -e^(-k/2) + sqrt(π/2k) erf(sqrt(k/2)) with k = 8.
  const double color = -std::exp(-4.0) + std::sqrt(std::numbers::pi / 16.0) * std::erf(2.0);
  ray.limit = glm::dvec4(glm::dvec3(color), -std::expm1(-4.0));
  ray.fewestSamples = 4;
  ray.mostSamples = 256;
  return ray;
}

// The finest picture that the limit of samples per ray admits, its error below that of the tests' by 10⁴.
glm::dvec4 finest(const ConvergingRay& ray) {
  return renderReference(withSamples(ray, 49152), {1, 1}, 1).pixels[0];
}

// The scalar is the cube of the way along the diagonal of the cube of voxel centres; extinction 6 s, colour
// s.
ConvergingRay diagonal() {
  Grid grid;
  grid.dims = glm::ivec3(2);
  grid.originMm = glm::dvec3(-0.5);
  std::vector<double> values(8, 0.0);
  values[7] = 1.0;
  ConvergingRay ray;
  ray.what = "B6, s = t^3, extinction 6 s, colour s";
  ray.scene = rayThrough(std::make_shared<const Volume>(grid, values, Rescale{}, std::nullopt, VolumeInfo{}),
                         glm::normalize(white));
  ray.scene.crop = {glm::dvec3(0.25), glm::dvec3(0.75)};
  ray.scene.transferFunction = {
      smallUnitMm, {extinctionPoint(0.0, 0.0, glm::dvec3(0.0)), extinctionPoint(1.0, 6.0, white)}};
  ray.lengthMm = std::sqrt(3.0);
  ray.limit = finest(ray);
  ray.fewestSamples = 8;
  ray.mostSamples = 512;
  return ray;
}

// s = sin²(2.5πt) in 1025 voxels over 1 mm; extinction 20 exp(-(s-½)²/(2·0.1²)), colour s. The Gaussian is
// passed twice in each of five rises and falls, 0.03 mm at a time, so its order shows from 64 samples on, and
// to 256, where a step still is four voxels, whose straight pieces the finest picture sees.
ConvergingRay wave() {
  constexpr int intervals = 1024, knots = 2048;
  std::vector<double> values;
  for (int i = 0; i <= intervals; ++i) {
    const double sine = std::sin(2.5 * std::numbers::pi * i / intervals);
    values.push_back(sine * sine);
  }
  ConvergingRay ray;
  ray.what = "N1, s = sin^2, Gaussian of s, colour s";
  ray.scene = rayThrough(columnOf(values, 1.0 / intervals));
  ray.scene.crop.lower.y = 0.5 / (intervals + 1);
  ray.scene.crop.upper.y = 1.0 - ray.scene.crop.lower.y;
  ray.scene.transferFunction.unitDistanceMm = smallUnitMm;
  for (int i = 0; i <= knots; ++i) {
    const double s = static_cast<double>(i) / knots;
    const double x = (s - 0.5) / 0.1;
    ray.scene.transferFunction.points.push_back(
        extinctionPoint(s, 20.0 * std::exp(-0.5 * x * x), glm::dvec3(s)));
  }
  ray.limit = finest(ray);
  ray.fewestSamples = 64;
  ray.mostSamples = 256;
  return ray;
}

} // namespace

std::vector<ConvergingRay> convergingRays() {
  return {ramp(), diagonal(), wave()};
}

Scene withSamples(const ConvergingRay& ray, int samples) {
  Scene scene = ray.scene;
  scene.quality.stepVoxels = stepFor(scene, ray.lengthMm, samples);
  return scene;
}

double largestError(const glm::dvec4& pixel, const glm::dvec4& limit) {
  const glm::dvec4 error = glm::abs(pixel - limit);
  return std::max({error.r, error.g, error.b, error.a});
}

} // namespace limn::test
