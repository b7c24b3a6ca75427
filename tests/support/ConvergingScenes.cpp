// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/ConvergingScenes.h"

#include "reference/ReferenceIntegrator.h"

#include <cmath>
#include <numbers>

namespace limn::test {
namespace {

using nlohmann::json;

std::vector<int> doubled(int first, int last) {
  std::vector<int> samples;
  for (int count = first; count <= last; count *= 2)
    samples.push_back(count);
  return samples;
}

ConvergingRay convergingRay(const AnalyticRay& ray, std::vector<int> samples) {
  ConvergingRay result;
  result.what = ray.id + (ray.what.empty() ? "" : ", " + ray.what);
  result.scene = ray.scene;
  result.alpha = ray.alpha;
  result.color = ray.color;
  result.samples = std::move(samples);
  return result;
}

// The order of an extinction k s shows once a step is thinner than a depth of 1.
std::vector<ConvergingRay> convergingExtinction(const json& one) {
  const double k = one["parameters"]["k"];
  const int first = k < 10.0 ? 4 : 32;
  std::vector<ConvergingRay> rays;
  for (const AnalyticRay& ray : rampRays(one))
    rays.push_back(convergingRay(ray, doubled(first, 256)));
  return rays;
}

// The order shows once a step is short against 1-a, in which the extinction bends. With a = 1 it is singular
// at the end, where the midpoint rule errs by m h/2 ln 2: order 1.
ConvergingRay convergingOpacity(const json& one) {
  const double a = one["parameters"]["a"];
  const int first = a < 0.9 ? 2 : a < 0.99 ? 8 : 64;
  ConvergingRay ray = convergingRay(rampRays(one).front(), doubled(first, 8 * first));
  ray.floor = 1e-13;
  if (a == 1.0)
    ray.order = 1.0;
  ray.showsInFloats = 1.0 - *ray.alpha > 4e-3;
  return ray;
}

// Odd numbers of steps have a sample on the step of the function, off by half a step: order 1.
ConvergingRay convergingStep(const json& one) {
  ConvergingRay ray = convergingRay(rampRays(one).front(), {31, 63, 127, 255});
  ray.order = 1.0;
  return ray;
}

} // namespace

// s = sin²(2.5πt) in 1025 voxels over 1 mm; extinction 20 exp(-(s-½)²/(2·0.1²)), colour s. The Gaussian is
// passed twice in each of five rises and falls, 0.03 mm at a time, so its order shows from 64 samples on, and
// to 256, where a step still is four voxels, whose straight pieces the finest picture sees.
ConvergingRay convergingWave() {
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
  const glm::dvec4 finest = renderReference(withSamples(ray, 49152), {1, 1}, 1).pixels[0];
  ray.alpha = finest.a;
  ray.color = glm::dvec3(finest);
  ray.samples = {64, 128, 256};
  return ray;
}

std::vector<ConvergingRay> convergingRays(const json& one) {
  const std::string id = one["id"];
  if (id.rfind("B1_", 0) == 0)
    return convergingExtinction(one);
  if (id.rfind("B2_", 0) == 0)
    return {convergingOpacity(one)};
  if (id.rfind("K3_", 0) == 0)
    return {convergingStep(one)};
  if (id.rfind("B6_", 0) != 0)
    return {};
  ConvergingRay diagonal = convergingRay(rampRays(one).front(), doubled(8, 512));
  diagonal.lengthMm = std::sqrt(3.0);
  return {diagonal};
}

Scene withSamples(const ConvergingRay& ray, int samples) {
  Scene scene = ray.scene;
  scene.quality.stepVoxels = stepFor(scene, ray.lengthMm, samples);
  return scene;
}

double largestError(const ConvergingRay& ray, const glm::dvec4& pixel) {
  double largest = ray.alpha ? std::abs(pixel.a - *ray.alpha) : 0.0;
  for (int channel = 0; ray.color && channel < 3; ++channel)
    largest = std::max(largest, std::abs(pixel[channel] - (*ray.color)[channel]));
  return largest;
}

} // namespace limn::test
