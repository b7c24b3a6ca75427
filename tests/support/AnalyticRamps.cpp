// SPDX-License-Identifier: GPL-3.0-or-later
// Ramps: the scalar runs linearly along the ray from 0 to 1 between voxel centres, to which the box is
// cropped. Extinctions linear in the scalar are made with a tiny unit distance u, over which an opacity a =
// κ·u is an extinction κ up to a relative κ·u/2; u = 1e-9 D keeps that below the tolerance of 1e-8.
#include "support/AnalyticScenes.h"

#include <cmath>

namespace limn::test {
namespace {

using nlohmann::json;

constexpr double smallUnit = smallUnitMm;
constexpr double manySamples = 49152.0; // 2¹⁴·3: kinks at thirds and at powers of two fall between samples

ControlPoint pointAt(double scalar, double extinction, double unit, const glm::dvec3& color) {
  return {scalar, color, -std::expm1(-extinction * unit)};
}

// A ramp of length 1 mm between two voxel centres, in `samples` steps.
Scene ramp(double samples = manySamples, bool isReversed = false) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0), {0.0, isReversed ? -1.0 : 1.0, 0.0});
  scene.crop.lower.y = 0.25;
  scene.crop.upper.y = 0.75;
  scene.quality.stepVoxels = 1.0 / samples;
  return scene;
}

AnalyticRay rampRay(const json& one, std::string what, Scene scene, const char* alphaKey) {
  AnalyticRay ray = rayOf(one, std::move(what), std::move(scene));
  ray.alpha = expectedOf(one, alphaKey);
  ray.glStepVoxels = 16.0 * ray.scene.quality.stepVoxels;
  return ray;
}

std::vector<AnalyticRay> linearExtinction(const json& one) {
  const double k = one["parameters"]["k"];
  std::vector<AnalyticRay> rays;
  for (const bool isReversed : {false, true}) {
    Scene scene = ramp(manySamples, isReversed);
    scene.transferFunction = {
        smallUnit,
        {pointAt(0.0, 0.0, smallUnit, glm::dvec3(0.0)), pointAt(1.0, k, smallUnit, glm::dvec3(1.0))}};
    rays.push_back(rampRay(one, isReversed ? "reversed" : "forward", scene, "alpha"));
    rays.back().color = glm::dvec3(expectedOf(one, isReversed ? "I_color_eq_s_reversed" : "I_color_eq_s"));
  }
  return rays;
}

// A part of B2's ramp with a = 1, whose depth is m ∫ -ln(1-s) ds; opacity is limited to 1 - 2⁻²⁴, which takes
// m ∫ over [0, 2⁻²⁴] of -ln(x) - 24 ln 2 = m·2⁻²⁴ from the end.
AnalyticRay singularPart(const AnalyticRay& whole, double m, double from, double to) {
  const auto primitive = [](double s) { return s < 1.0 ? (1.0 - s) * std::log(1.0 - s) + s : 1.0 - 0x1p-24; };
  AnalyticRay part = whole;
  part.what = std::to_string(from) + " to " + std::to_string(to);
  part.scene.crop.lower.y = 0.25 + 0.5 * from;
  part.scene.crop.upper.y = 0.25 + 0.5 * to;
  part.scene.quality.stepVoxels = (to - from) / manySamples;
  part.alpha = -std::expm1(-m * (primitive(to) - primitive(from)));
  part.glStepVoxels = 0.0;
  return part;
}

// With a = 1 the extinction has a logarithmic singularity at the far end, where the midpoint rule errs by
// m·h/2·ln 2: 2.4e-7 in alpha for one ray, above the case's tolerance. Two parts, one of them the last
// thousandth, meet it; the whole ray is held to the rule's own error.
std::vector<AnalyticRay> linearOpacity(const json& one) {
  const json& p = one["parameters"];
  const double m = p["m"];
  Scene scene = ramp();
  scene.transferFunction = {1.0 / m,
                            {{0.0, glm::dvec3(1.0), 0.0}, {1.0, glm::dvec3(1.0), p["a"].get<double>()}}};
  AnalyticRay whole = rampRay(one, "", scene, "alpha");
  if (p["a"] != 1.0)
    return {whole};
  const AnalyticRay first = singularPart(whole, m, 0.0, 0.999);
  const AnalyticRay last = singularPart(whole, m, 0.999, 1.0);
  whole.tolerance = std::exp(-m) * m / manySamples / 2.0 * std::log(2.0) * 1.01;
  return {whole, first, last};
}

// B3: sampling is exact to rounding once the spectrum of the Gaussian has fallen to nothing at its
// rate. 2.5/σ samples put a whole number of the function's chords between two, so that those add no error of
// their own.
std::vector<AnalyticRay> gaussian(const json& one) {
  const json& p = one["parameters"];
  const double centre = p["s0"], sigma = p["sigma"], kappa = p["kappaD"];
  Scene scene = ramp();
  scene.transferFunction.unitDistanceMm = smallUnit;
  // The trapezoid sum over knots σ/20 apart is exact to rounding for a Gaussian.
  for (double x = -8.0; x <= 8.0; x += 0.05) {
    const double scalar = centre + x * sigma;
    scene.transferFunction.points.push_back(
        pointAt(scalar, kappa * std::exp(-0.5 * x * x), smallUnit, glm::dvec3(1.0)));
  }
  const AnalyticRay fine = rampRay(one, "", scene, "alpha");
  AnalyticRay coarse = fine;
  coarse.what = "as few samples as see it";
  coarse.scene.quality.stepVoxels = sigma / 5.0;
  coarse.glStepVoxels = 0.0;
  return {fine, coarse};
}

// B4: midpoint sampling sees the spike as often as samples fall into it. The file counts a sample on either
// edge of the spike; the definition, where the last of coincident points holds, counts the lower edge only.
// So where samples fall on both edges there is one hit less, and where the arithmetic on the way to the edges
// is inexact (N = 1000) the count is a matter of the last bit: left out.
std::vector<AnalyticRay> spike(const json& one) {
  const json& p = one["parameters"];
  const double low = p["s0"].get<double>() - p["w"].get<double>() / 2.0;
  const double high = p["s0"].get<double>() + p["w"].get<double>() / 2.0;
  const double kappa = p["kappaD"];
  std::vector<AnalyticRay> rays;
  for (const auto& [key, naive] : one["expected"]["naive_midpoint"].items()) {
    const double samples = std::stod(key);
    const double atLow = low * samples - 0.5, atHigh = high * samples - 0.5;
    const bool isOnEdges = std::abs(atLow - std::round(atLow)) < 1e-6;
    if (isOnEdges != (std::abs(atHigh - std::round(atHigh)) < 1e-6))
      throw std::runtime_error("B4: a sample on one edge of the spike only");
    if (isOnEdges && std::exp2(std::round(std::log2(samples))) != samples)
      continue;
    Scene scene = ramp(samples);
    scene.transferFunction = {smallUnit,
                              {pointAt(low, 0.0, smallUnit, white), pointAt(low, kappa, smallUnit, white),
                               pointAt(high, kappa, smallUnit, white), pointAt(high, 0.0, smallUnit, white)}};
    rays.push_back(rayOf(one, "N=" + key, scene));
    const double hits = naive["hits"];
    rays.back().alpha =
        isOnEdges ? -std::expm1(-(hits - 1.0) * kappa / samples) : naive["alpha"].get<double>();
  }
  return rays;
}

// B5: the whole box, with half a voxel of constant value at either end; the extinction is k·s².
AnalyticRay plateaus(const json& one) {
  const int count = one["parameters"]["N"];
  const double k = one["parameters"]["k"];
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(static_cast<double>(i) / (count - 1));
  Scene scene = rayThrough(columnOf(values, 1.0 / count));
  scene.quality.stepVoxels = count / manySamples;
  scene.transferFunction.unitDistanceMm = smallUnit;
  // Chords of a parabola overestimate its mean by the sixth of their squared length: 6e-10 here.
  constexpr int chords = 16384;
  for (int i = 0; i <= chords; ++i) {
    const double s = static_cast<double>(i) / chords;
    scene.transferFunction.points.push_back(pointAt(s, k * s * s, smallUnit, glm::dvec3(1.0)));
  }
  return rampRay(one, "", scene, "alpha_texture_box");
}

// B6: f = xyz along the diagonal of the cube of voxel centres.
AnalyticRay diagonal(const json& one) {
  Grid grid;
  grid.dims = glm::ivec3(2);
  grid.originMm = glm::dvec3(-0.5);
  std::vector<double> values(8, 0.0);
  values[7] = 1.0;
  const auto volume = std::make_shared<const Volume>(grid, values, Rescale{}, std::nullopt, VolumeInfo{});
  Scene scene = rayThrough(volume, glm::normalize(glm::dvec3(1.0)));
  scene.crop = {glm::dvec3(0.25), glm::dvec3(0.75)};
  scene.quality.stepVoxels = std::sqrt(3.0) / manySamples;
  const double kappa = one["parameters"]["kappa"];
  scene.transferFunction = {
      smallUnit,
      {pointAt(0.0, 0.0, smallUnit, glm::dvec3(0.0)), pointAt(1.0, kappa, smallUnit, glm::dvec3(1.0))}};
  AnalyticRay ray = rampRay(one, "", scene, "alpha");
  ray.color = glm::dvec3(expectedOf(one, "I_color_eq_s"));
  return ray;
}

// K3: of an even number of samples half lie behind the step.
AnalyticRay stepFunction(const json& one) {
  const double kappa = one["parameters"]["kappaD"];
  Scene scene = ramp(1000.0);
  scene.transferFunction = {smallUnit,
                            {pointAt(0.0, 0.0, smallUnit, white), pointAt(0.5, 0.0, smallUnit, white),
                             pointAt(0.5, kappa, smallUnit, white), pointAt(1.0, kappa, smallUnit, white)}};
  AnalyticRay ray = rayOf(one, "", scene);
  ray.alpha = expectedOf(one, "alpha_ramp");
  return ray;
}

} // namespace

std::vector<AnalyticRay> rampRays(const json& one) {
  const std::string id = one["id"];
  if (id.starts_with("B1_"))
    return linearExtinction(one);
  if (id.starts_with("B2_"))
    return linearOpacity(one);
  if (id.starts_with("B3_"))
    return gaussian(one);
  if (id.starts_with("B4_"))
    return spike(one);
  if (id.starts_with("B5_"))
    return {plateaus(one)};
  if (id.starts_with("B6_"))
    return {diagonal(one)};
  if (id.starts_with("K3_"))
    return {stepFunction(one)};
  return {};
}

} // namespace limn::test
