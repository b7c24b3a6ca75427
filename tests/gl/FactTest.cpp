// SPDX-License-Identifier: GPL-3.0-or-later
// Cases of kind `fact` that the code must agree with: background arithmetic, so the file states no tolerance.
// In C++ they hold to rounding, in GLSL to 2e-6 as the other cases do.
#include "gl/HelperCases.h"
#include "glsl/programs/GlslEvaluator.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "reference/SampleLighting.h"
#include "scene/basics/StableMath.h"
#include "scene/function/PiecewiseTable.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"
#include "support/GlTest.h"

namespace limn {
namespace {

using nlohmann::json;

double figure(const json& one, const char* key) {
  return test::expectedFigure(one["expected"][key]);
}

// Alpha of one ray in both renderers.
void expectAlpha(const json& one, const Scene& scene, const char* key, test::CaseLedger& ledger) {
  RayCaster caster;
  ledger.expectNear(one["id"], key, renderReference(scene, {1, 1}, 1).pixels[0].a, figure(one, key), 1e-12);
  ledger.expectNear(one["id"], key, caster.render(scene, {1, 1}).pixels[0].a, figure(one, key), 2e-6);
}

// A5: the opacity is corrected after the lookup.
void checkCorrection(const json& one, test::CaseLedger& ledger) {
  const double length = one["parameters"]["f"];
  Scene scene = test::rayThrough(test::boxOf(glm::dvec3(length), one["parameters"]["s"]));
  scene.transferFunction = {
      1.0, {{0.0, white, one["parameters"]["a_left"]}, {1.0, white, one["parameters"]["a_right"]}}};
  expectAlpha(one, scene, "alpha_step_right", ledger);
}

// K2: small opacities are not rounded to levels.
void checkSmallOpacity(const json& one, test::CaseLedger& ledger) {
  const double length = one["parameters"]["n"];
  for (const auto& [key, opacity] : {std::pair{"exact_0.001", 0.001}, {"exact_1/255", 1.0 / 255.0}}) {
    Scene scene = test::rayThrough(test::boxOf(glm::dvec3(length)));
    scene.transferFunction = test::constantFunction(opacity, glm::dvec3(1.0));
    scene.quality.stepVoxels = 1.0 / length;
    expectAlpha(one, scene, key, ledger);
  }
}

// G4: the gradient is the lecture's, and the paper's vector is -2 times it.
void checkSign(const json& one, test::CaseLedger& ledger) {
  const double lower = one["parameters"]["f(i-1)"], upper = one["parameters"]["f(i+1)"];
  const auto volume = test::columnOf({lower, lower, upper}, one["parameters"]["spacing"]);
  const double gradient = gradientAtVoxel(*volume, {0, 1, 0}).y;
  ledger.expectNear(one["id"], "lecture", gradient, figure(one, "lecture"), 1e-12);
  ledger.expectNear(one["id"], "paper", -2.0 * gradient, figure(one, "paper"), 1e-12);
}

// G5: moduli spread evenly over 0..100 in 2000 steps, and a metal voxel whose neighbours see half of it.
void checkOutlier(const json& one, test::CaseLedger& ledger) {
  const double metal = one["parameters"]["gmax"], modulus = one["parameters"]["g"];
  Grid grid;
  grid.dims = {2001, 20, 25};
  std::vector<double> voxels;
  for (int row = 0; row < grid.dims.y * grid.dims.z; ++row)
    for (int i = 0; i < grid.dims.x; ++i)
      voxels.push_back(0.025 * i * i);
  voxels[voxelOffset(grid.dims, 20, 10, 12)] += 2.0 * metal;
  const Volume volume(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{});
  Shading shading;
  shading.model = ShadingModel::enhanced;
  shading.exponentRange = {5.0, 125.0};
  const std::tuple<const char*, const char*, GradientReference> rows[] = {
      {"ratio_max", "SP_max(5..125)", LargestReference{}},
      {"ratio_p999", "SP_p999", PercentileReference{99.9}}};
  for (const auto& [ratioKey, exponentKey, reference] : rows) {
    shading.gradientReference = reference;
    const double r = gradientRatio(lightingTerms(shading), gradientScale(volume, shading), modulus);
    // The moduli are 0.05 apart, and the metal's differ from 3000 by the 1 of the ramp below it.
    ledger.expectNear(one["id"], ratioKey, r, figure(one, ratioKey), 5e-4);
    ledger.expectNear(one["id"], exponentKey, mapped(r, 5.0, 125.0), figure(one, exponentKey), 120.0 * 5e-4);
  }
}

// K5: 16-bit voxels are normalised over their range, not over that of their type.
void checkNormalisation(const json& one, test::CaseLedger& ledger) {
  for (const auto& [key, value] : {std::pair{"-32768", -32768.0}, {"0", 0.0}, {"32767", 32767.0}})
    ledger.expectNear(one["id"], key, normalisedValue({-32768.0, 32767.0}, value), figure(one, key), 1e-12);
  ledger.expectNear(one["id"], "12 bits", normalisedValue({0.0, 4095.0}, 4095.0),
                    figure(one, "4095_as_unorm16") * figure(one, "scale_12bit"), 1e-12);
}

// M2: one ulp below 1 the power is right, and above 1 the cosine is limited.
void checkPower(const json& one, test::CaseLedger& ledger) {
  const double exponent = one["parameters"]["SP"];
  const GlslEvaluator evaluate({"stable_math.glsl"});
  for (const auto& [cosine, expected] :
       {std::pair{1.0 - 0x1p-24, figure(one, "one_ulp_below")}, {1.0 + 0x1p-23, 1.0}}) {
    ledger.expectNear(one["id"], "C++", blinnTerm(cosine, exponent), expected, 1e-12);
    ledger.expectNear(one["id"], "GLSL",
                      evaluate("blinnTerm(v.x, v.y)", {glm::vec4(cosine, exponent, 0.0, 0.0)})[0].x, expected,
                      2e-6);
  }
}

const std::pair<const char*, test::HelperCheck> rows[] = {
    {"A5_", checkCorrection},   {"G4_", checkSign},          {"G5_", checkOutlier},
    {"K2_", checkSmallOpacity}, {"K5_", checkNormalisation}, {"M2_", checkPower}};

using FactCases = test::GlTest;

TEST_F(FactCases, theCodeAgreesWithTheFactsItRestsOn) {
  test::CaseLedger ledger;
  const auto isIn = [](const json& one, const char* prefix) {
    return one["id"].get_ref<const std::string&>().rfind(prefix, 0) == 0;
  };
  const json cases = test::analyticCases();
  for (const json& one : cases)
    for (const auto& [prefix, check] : rows)
      if (isIn(one, prefix))
        check(one, ledger);
  ledger.expectEvery(cases, [&isIn](const json& one) {
    return std::any_of(std::begin(rows), std::end(rows),
                       [&](const auto& row) { return isIn(one, row.first); });
  });
}

} // namespace
} // namespace limn
