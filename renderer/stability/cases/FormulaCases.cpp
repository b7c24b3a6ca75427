// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/StableMath.h"
#include "scene/light/Shading.h"
#include "stability/GlslEvaluator.h"
#include "stability/Measures.h"
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

} // namespace

std::vector<HardCase> formulaCases() {
  return {{"H1", "Gradients of zero, tiny and huge length give finite pictures and exact normals", gradients},
          {"H2", "Highlights with exponents and cosines at the ends of their range are defined", powers},
          {"H3", "Huge exponents magnify roundings no more than they must", hugeExponents}};
}

} // namespace limn
