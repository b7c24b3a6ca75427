// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/PictureFigures.h"
#include "scene/basics/StableMath.h"
#include "scene/light/Shading.h"
#include "stability/GlslEvaluator.h"
#include "stability/Measures.h"
#include "stability/cases/Cases.h"

#include <cmath>

namespace limn {
namespace {

// White material, so that ambient, diffuse and specular light add up to 1.75.
Scene dazzling(ShadingModel model) {
  Scene scene = wholeVolume(smoothVolume(16), model, 0.0, 100.0, {0.6, 0.64, 0.48});
  for (ControlPoint& point : scene.transferFunction.points)
    point.color = glm::dvec3(1.0);
  scene.transferFunction.unitDistanceMm = 1.0;
  return scene;
}

std::vector<Finding> limits(Workbench& bench) {
  std::vector<Finding> findings;
  for (const ShadingModel model : {ShadingModel::robust, ShadingModel::enhanced, ShadingModel::classic})
    findings += inEachEngine(bench, std::string("no pixel brighter than opaque, ") + nameOf(model), {},
                             "pixels with a colour above alpha, or that are not finite or outside 0..1",
                             [model](const Draw& draw) {
                               return unsoundPixels(draw(dazzling(model), {32, 32}));
                             });
  findings.push_back(withOpenGl(bench, "gl", "the light does add up to more", [&bench] {
    const Overflow overflow =
        overflowOf(bench.rays().renderUnlimited(dazzling(ShadingModel::classic), {32, 32}));
    return atMost("gl", "the light does add up to more", overflow.share > 0.0 ? 0.0 : 1.0, 0.0,
                  "1 where no pixel would exceed full brightness without the limit");
  }));
  return findings;
}

std::vector<Finding> neutralExtras(Workbench& bench) {
  return inEachEngine(
      bench, "robust with its extras neutral", {}, "largest difference from the enhanced model: none",
      [](const Draw& draw) {
        Scene robust = dazzling(ShadingModel::robust);
        robust.shading.energyFactor = false;
        robust.shading.significance.reset();
        robust.shading.knee.reset();
        robust.shading.gradientReference = PercentileReference{100.0};
        return largestDifference(draw(robust, {32, 32}), draw(dazzling(ShadingModel::enhanced), {32, 32}));
      });
}

constexpr int edge = 32;
constexpr glm::ivec3 outlier{13, 17, 20};

// A pixel per voxel along y: pixel (x, y) sees the column i = x, k = edge - 1 - y.
DrawnPicture withOutlier(const Draw& draw, double value) {
  const auto smooth = smoothVolume(edge);
  const auto volume = volumeOf(smooth->grid(), [&](int i, int j, int k) {
    return glm::ivec3(i, j, k) == outlier ? value : smooth->value({i, j, k});
  });
  Scene scene = wholeVolume(volume, ShadingModel::robust, 0.0, 100.0);
  scene.camera.heightMm = edge;
  return draw(scene, glm::ivec2(edge));
}

std::vector<Finding> outliers(Workbench& bench) {
  const double level = 1.0 / 255.0;
  return inEachEngine(
      bench, "one voxel of ten times the largest value, robust", {level, level, level},
      "largest change of pixels two voxels away: below one level, because one voxel does not set the "
      "gradient that counts as 1",
      [](const Draw& draw) {
        const DrawnPicture without = withOutlier(draw, smoothVolume(edge)->value(outlier));
        return differenceBeside(outlier, withOutlier(draw, 1000.0), without);
      });
}

// The knee at 0.8: nothing below it, 1 - 0.04/(m - 0.6) above.
std::vector<Finding> kneeCurve(Workbench& bench) {
  std::vector<glm::vec4> arguments;
  for (int i = 0; i <= 4000; ++i)
    arguments.push_back(glm::vec4(glm::vec3(0.0025f * static_cast<float>(i), 0.1f, 0.0f), 0.0f));
  const auto worst = [&arguments](const auto& valueOf) {
    double largest = 0.0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const double m = arguments[i].x;
      const double expected = m <= 0.8 ? m : 1.0 - 0.04 / (m - 0.6);
      largest = std::max(largest, finiteOrInfinite(std::abs(valueOf(i) - expected)));
    }
    return largest;
  };
  const std::string reason =
      "largest distance from the curve's closed form: the identity up to 0.8, below 1 above";
  const std::string what = "the knee from 0 to 10";
  const auto inCpp = [&](std::size_t i) { return knee(glm::dvec3(arguments[i].x), 0.8).r; };
  return {atMost("cpp", what, worst(inCpp), 1e-12, reason), withOpenGl(bench, "glsl", what, [&] {
            const std::vector<glm::vec4> inGlsl =
                GlslEvaluator({"stable_math.glsl"})("knee(vec3(v.x), 0.8), 0.0", arguments);
            return atMost("glsl", what, worst([&](std::size_t i) { return double(inGlsl[i].r); }), 1e-6,
                          reason);
          })};
}

// By how much a highlight ever falls while the normal turns towards it.
// `shown` gives the brightness for each of some cosines and exponents.
double largestFall(const std::function<std::vector<double>(const std::vector<glm::vec4>&)>& shown) {
  double fall = 0.0;
  for (const float exponent : {1.0f, 5.0f, 32.0f, 125.0f, 1024.0f}) {
    std::vector<glm::vec4> arguments;
    for (int i = 0; i <= 4000; ++i)
      arguments.push_back({static_cast<float>(i) / 4000.0f, exponent, 0.0f, 0.0f});
    const std::vector<double> brightness = shown(arguments);
    for (std::size_t i = 1; i < brightness.size(); ++i)
      fall = std::max(fall, finiteOrInfinite(brightness[i - 1] - brightness[i]));
  }
  return fall;
}

std::vector<double> highlightsInCpp(const std::vector<glm::vec4>& arguments) {
  std::vector<double> shown;
  shown.reserve(arguments.size());
  for (const glm::vec4& v : arguments)
    shown.push_back(knee(glm::dvec3(1.0 + blinnTerm(v.x, v.y)), 0.8).r);
  return shown;
}

std::vector<double> highlightsInGlsl(const std::vector<glm::vec4>& arguments) {
  std::vector<double> shown;
  for (const glm::vec4& value :
       GlslEvaluator({"stable_math.glsl"})("knee(vec3(1.0 + blinnTerm(v.x, v.y)), 0.8), 0.0", arguments))
    shown.push_back(value.r);
  return shown;
}

std::vector<Finding> monotoneHighlights(Workbench& bench) {
  const std::string what = "a surface turning towards the light, full to bright";
  return {atMost("cpp", what, largestFall(highlightsInCpp), 1e-15,
                 "by how much it ever darkens; a rounding of double"),
          withOpenGl(bench, "glsl", what, [&what] {
            return atMost("glsl", what, largestFall(highlightsInGlsl), 2e-7,
                          "by how much it ever darkens; roundings of float");
          })};
}

std::vector<Finding> overflow(Workbench& bench) {
  std::vector<Finding> findings = limits(bench);
  findings += neutralExtras(bench);
  findings += outliers(bench);
  findings += kneeCurve(bench);
  findings += monotoneHighlights(bench);
  return findings;
}

} // namespace

std::vector<HardCase> highlightCases() {
  return {
      {"H40", "Highlights never exceed full brightness, and one voxel does not rule the picture", overflow}};
}

} // namespace limn
