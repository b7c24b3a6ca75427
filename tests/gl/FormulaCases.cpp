// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas of stable_math.glsl, the compositing of equal layers, and the transfer function's lookup.
#include "gl/HelperCases.h"

#include "glsl/programs/GlslEvaluator.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/StableMath.h"
#include "support/AnalyticScenes.h"

#include <numbers>

namespace limn::test {
namespace {

using nlohmann::json;

double gpuValue(const std::string& expression, const glm::dvec4& argument) {
  static const GlslEvaluator evaluate({"stable_math.glsl"});
  return evaluate(expression, {glm::vec4(argument)})[0].x;
}

} // namespace

double expectedFigure(const json& entry) {
  return entry.is_object() ? entry["value"].get<double>() : entry.get<double>();
}

void expectBoth(const json& one, CaseLedger& ledger, const std::string& what, double expected, double cpu,
                double gpu) {
  const json& tolerance = one["tolerance"];
  ledger.expectNear(one["id"], what + " in C++", cpu, expected, tolerance["cpu_double"]);
  ledger.expectNear(one["id"], what + " in GLSL", gpu, expected,
                    tolerance.value("gpu_float_target", 2e-6) * std::max(1.0, std::abs(expected)));
}

void checkMaps(const json& one, CaseLedger& ledger) {
  const json& p = one["parameters"];
  const glm::dvec4 sp(p["g_over_gmax"], p["SPmin"], p["SPmax"], 0.0);
  const glm::dvec4 o(p["g_over_gmax"], p["Omin"], p["Omax"], 0.0);
  expectBoth(one, ledger, "SP", expectedFigure(one["expected"]["SP"]), mapped(sp.x, sp.y, sp.z),
             gpuValue("mapped(v.x, v.y, v.z)", sp));
  expectBoth(one, ledger, "O", expectedFigure(one["expected"]["O"]), mapped(o.x, o.y, o.z),
             gpuValue("mapped(v.x, v.y, v.z)", o));
}

void checkBlinnTerm(const json& one, CaseLedger& ledger) {
  const json& p = one["parameters"];
  const double cosine = std::cos(p["angle_NH_deg"].get<double>() * std::numbers::pi / 180.0);
  // cos 90° is 6e-17 in double: the case means 0.
  const glm::dvec4 v(p["angle_NH_deg"] == 90 ? 0.0 : cosine, p["SP"], 0.0, 0.0);
  expectBoth(one, ledger, "spec", expectedFigure(one["expected"]["spec"]), blinnTerm(v.x, v.y),
             gpuValue("blinnTerm(v.x, v.y)", v));
}

void checkEnergyFactor(const json& one, CaseLedger& ledger) {
  const glm::dvec4 v(one["parameters"]["n"], one["parameters"]["SPmax"], 0.0, 0.0);
  expectBoth(one, ledger, "E", expectedFigure(one["expected"]["E"]), energyFactor(v.x, v.y),
             gpuValue("energyFactor(v.x, v.y)", v));
}

void checkKnee(const json& one, CaseLedger& ledger) {
  const glm::dvec4 v(one["parameters"]["m"], 0.1, 0.1, one["parameters"]["k"]);
  expectBoth(one, ledger, "m_out", expectedFigure(one["expected"]["m_out"]), knee(glm::dvec3(v), v.w).x,
             gpuValue("knee(v.xyz, v.w).x", v));
}

void checkCurves(const json& one, CaseLedger& ledger) {
  const glm::dvec4 v(one["parameters"]["r"], one["parameters"]["beta"], 0.5, 0.0);
  expectBoth(one, ledger, "log", expectedFigure(one["expected"]["log"]), logCurve(v.x, v.y),
             gpuValue("logCurve(v.x, v.y)", v));
  expectBoth(one, ledger, "gamma_half", expectedFigure(one["expected"]["gamma_half"]), gammaCurve(v.x, v.z),
             gpuValue("gammaCurve(v.x, v.z)", v));
}

// D2: one sample in each of N layers whose thickness is the unit distance, over one another.
void checkEqualLayers(const json& one, CaseLedger& ledger) {
  const double layers = one["parameters"]["N"];
  Scene scene = rayThrough(boxOf({1.0, layers, 1.0}));
  scene.transferFunction = constantFunction(one["parameters"]["a"], glm::dvec3(1.0));
  scene.quality.stepVoxels = stepFor(scene, layers, layers);
  const ReferencePicture reference = renderReference(scene, {1, 1}, 1);
  EXPECT_EQ(reference.samples[0], layers);
  RayCaster caster;
  expectBoth(one, ledger, "over", expectedFigure(one["expected"]["exact"]), reference.pixels[0].a,
             caster.render(scene, {1, 1}).pixels[0].a);
}

// K1: a lookup table of M texels reads the identity right at s·(M-1)+½ only; the exact classification has no
// such coordinate, so it meets the case's figures and the identity everywhere to rounding.
void checkFunctionCoordinate(const json& one, CaseLedger& ledger) {
  const GlslEvaluator evaluate({"stable_math.glsl", "piecewise.glsl", "classification.glsl"},
                               "float opacityAt(float s) { return materialOf(s).opacity; }");
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  scene.transferFunction = {1.0, {{0.0, glm::dvec3(1.0), 0.0}, {1.0, glm::dvec3(1.0), 1.0}}};
  const auto opacityOnGpu = [&](double s) {
    return evaluate("opacityAt(v.x)", {glm::vec4(static_cast<float>(s))}, scene)[0].x;
  };
  for (const double s : {0.25, 0.001}) {
    const std::string key = s == 0.25 ? "s=0.25_right" : "s=0.001_right";
    expectBoth(one, ledger, key, expectedFigure(one["expected"][key]),
               classify(scene.transferFunction, s).opacity, opacityOnGpu(s));
  }
  std::vector<glm::vec4> everywhere;
  for (int i = 0; i <= 4096; ++i)
    everywhere.emplace_back(static_cast<float>(i) / 4096.0f);
  const std::vector<glm::vec4> found = evaluate("opacityAt(v.x)", everywhere, scene);
  for (std::size_t i = 0; i < found.size(); ++i)
    expectBoth(one, ledger, "everywhere", everywhere[i].x,
               classify(scene.transferFunction, everywhere[i].x).opacity, found[i].x);
}

} // namespace limn::test
