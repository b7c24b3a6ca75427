// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/programs/GlslEvaluator.h"
#include "scene/PictureFigures.h"
#include "scene/basics/StableMath.h"
#include "scene/light/Shading.h"
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"

#include <cmath>
#include <limits>

namespace limn {
namespace {

// Unit vectors and lengths that are off, relative, for vectors of every length that GLSL treats as one.
double normalError(const glm::dvec4& normal, const glm::dvec3& direction, double length) {
  const double off = glm::length(glm::dvec3(normal) - direction);
  return finiteOrInfinite(std::max(off, std::abs(normal.w / length - 1.0)));
}

std::vector<glm::vec4> vectorsOfEveryLength() {
  std::vector<glm::vec4> vectors;
  for (int exponent = -36; exponent <= 37; ++exponent)
    for (const glm::vec3& v : {glm::vec3(1, 0, 0), glm::vec3(-0.3f, 0.9f, 0.2f), glm::vec3(1, 1, -1)})
      vectors.push_back(glm::vec4(v * static_cast<float>(std::pow(10.0, exponent)), 0.0f));
  return vectors;
}

std::vector<Finding> normalHelpers(Workbench& bench) {
  const std::vector<glm::vec4> vectors = vectorsOfEveryLength();
  const auto worst = [&vectors](const auto& normalOf) {
    double largest = 0.0;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      const glm::dvec3 v(vectors[i]);
      const double length = std::hypot(v.x, v.y, v.z);
      largest = std::max(largest, normalError(normalOf(i), v / length, length));
    }
    return largest;
  };
  const std::string what = "normals of vectors from 1e-36 to 1e37";
  return {atMost("cpp", what, worst([&](std::size_t i) { return safeNormal(glm::dvec3(vectors[i])); }), 1e-15,
                 "largest relative error; a few roundings of double"),
          withOpenGl(bench, "glsl", what, [&] {
            const std::vector<glm::vec4> inGlsl =
                GlslEvaluator({"stable_math.glsl"})("safeNormal(v.xyz)", vectors);
            return atMost("glsl", what, worst([&](std::size_t i) { return glm::dvec4(inGlsl[i]); }), 1e-6,
                          "largest relative error; a few roundings of float");
          })};
}

std::vector<Finding> zeroVectors(Workbench& bench) {
  const std::vector<glm::vec4> none = {glm::vec4(0.0f), glm::vec4(-0.0f, 0.0f, -0.0f, 0.0f)};
  const std::string what = "normal of zero", reason = "a vector of no length has no normal: exactly 0";
  double worstCpp = 0.0;
  for (const glm::vec4& value : none)
    worstCpp = std::max(worstCpp, finiteOrInfinite(glm::length(safeNormal(glm::dvec3(value)))));
  return {atMost("cpp", what, worstCpp, 0.0, reason), withOpenGl(bench, "glsl", what, [&] {
            double worst = 0.0;
            for (const glm::vec4& value : GlslEvaluator({"stable_math.glsl"})("safeNormal(v.xyz)", none))
              worst = std::max(worst, finiteOrInfinite(glm::length(glm::dvec4(value))));
            return atMost("glsl", what, worst, 0.0, reason);
          })};
}

std::vector<Finding> gradients(Workbench& bench) {
  std::vector<Finding> findings;
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust})
    findings += inEachEngine(bench, std::string("constant volume, ") + nameOf(model), {},
                             "pixels that are not finite or outside 0..1", [model](const Draw& draw) {
                               const auto volume = volumeOf(centredGrid(glm::ivec3(8), glm::dvec3(1.0)),
                                                            [](int, int, int) { return 50.0; });
                               Scene scene = wholeVolume(volume, model, 0.0, 100.0, {0.6, 0.64, 0.48});
                               scene.shading.opacityRange = {0.2, 1.0};
                               return unsoundPixels(draw(scene, {24, 24}));
                             });
  for (const double scale : {1e-30, 1e30})
    findings += inEachEngine(
        bench, scale > 1.0 ? "values times 1e30, enhanced" : "values times 1e-30, enhanced",
        {1e-6, 1e-6, 1e-6}, "largest difference from the unscaled picture; scalars are normalised in double",
        [scale](const Draw& draw) {
          const auto at = [&](double s) {
            return draw(wholeVolume(smoothVolume(12, s), ShadingModel::enhanced, 0.0, 100.0 * s), {24, 24});
          };
          return largestDifference(at(1.0), at(scale));
        });
  findings += normalHelpers(bench);
  findings += zeroVectors(bench);
  return findings;
}

// The error of cosine^exponent, relative to what conditioning allows: exponent · 1.2e-7 of the value, at
// least 1e-6 (HARD_CASES H2). Cosines and exponents are floats that both languages hold exactly.
double powerError(double value, double cosine, double exponent) {
  const double expected = cosine > 0.0 ? std::pow(std::min(cosine, 1.0), exponent) : 0.0;
  const double allowed = std::max(1e-6, exponent * 1.2e-7 * expected);
  return finiteOrInfinite(std::abs(value - expected)) / allowed;
}

std::vector<Finding> powersOf(Workbench& bench, const std::vector<float>& exponents) {
  const float ulp = std::numeric_limits<float>::epsilon();
  std::vector<glm::vec4> arguments;
  for (const float exponent : exponents)
    for (const float cosine : {-1.0f, -1e-7f, -0.0f, 0.0f, 1e-30f, 1e-3f, 0.5f, 0.9848077f, 0.9999f,
                               1.0f - ulp / 2.0f, 1.0f, 1.0f + ulp})
      arguments.push_back({cosine, exponent, 0.0f, 0.0f});
  const auto worst = [&arguments](const auto& powerOf) {
    double largest = 0.0;
    for (std::size_t i = 0; i < arguments.size(); ++i)
      largest = std::max(largest, powerError(powerOf(i), arguments[i].x, arguments[i].y));
    return largest;
  };
  const std::string reason = "largest error as a share of what is allowed: 1e-6, or exponent · 1.2e-7 of the "
                             "value, which one rounding of the cosine makes";
  const std::string what = "the function alone";
  const auto inCpp = [&](std::size_t i) { return blinnTerm(double(arguments[i].x), double(arguments[i].y)); };
  return {atMost("cpp", what, worst(inCpp), 1.0, reason), withOpenGl(bench, "glsl", what, [&] {
            const std::vector<glm::vec4> inGlsl =
                GlslEvaluator({"stable_math.glsl"})("blinnTerm(v.x, v.y)", arguments);
            return atMost("glsl", what, worst([&](std::size_t i) { return inGlsl[i].x; }), 1.0, reason);
          })};
}

std::vector<Finding> powers(Workbench& bench) {
  return powersOf(bench, {0.0f, 1e-6f, 1.0f, 8.0f, 32.0f, 128.0f, 1024.0f});
}

std::vector<Finding> hugeExponents(Workbench& bench) {
  std::vector<Finding> findings = powersOf(bench, {1e4f});
  findings += inEngines(
      bench, {Engine::rayCaster, Engine::slices, Engine::cpu}, "the largest exponent of a scene, 1024",
      {0, 5e-4, 5e-4},
      "largest difference from the reference where both take the same samples: 1024 · 1.2e-7 of a highlight, "
      "and four times as much for the normal's own rounding",
      [&bench](const Draw& draw) {
        Scene scene = wholeVolume(smoothVolume(8), ShadingModel::classic, 0.0, 100.0);
        scene.shading.exponent = 1024.0;
        scene.quality.stepVoxels = 1.0;
        return largestDifference(draw(scene, {24, 24}), bench.draw(Engine::reference, scene, {24, 24}));
      });
  return findings;
}

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

std::vector<HardCase> formulaCases() {
  return {
      {"H1", "Gradients of zero, tiny and huge length give finite pictures and exact normals", gradients},
      {"H2", "Highlights with exponents and cosines at the ends of their range are defined", powers},
      {"H3", "Huge exponents magnify roundings no more than they must", hugeExponents},
      {"H40", "Highlights never exceed full brightness, and one voxel does not rule the picture", overflow}};
}

} // namespace limn
