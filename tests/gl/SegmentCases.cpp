// SPDX-License-Identifier: GPL-3.0-or-later
// One pre-integrated segment: its mean extinction and the mean of its colour weighted by extinction, in
// renderer/scene/function/MeanMaterial and in preintegration.glsl.
#include "gl/HelperCases.h"

#include "glsl/programs/GlslEvaluator.h"
#include "scene/basics/StableMath.h"
#include "scene/function/MeanMaterial.h"
#include "support/AnalyticScenes.h"
#include "support/Orders.h"

namespace limn::test {
namespace {

using nlohmann::json;

// Over so short a unit an opacity is its extinction to 5e-14 of itself for the cases' extinctions up to 10.
constexpr double unitMm = 1e-14;

// Extinction and grey change linearly from one end of the scalars 0..1 to the other.
Scene segmentScene(double fromExtinction, double toExtinction, double fromGrey, double toGrey) {
  Scene scene = rayThrough(columnOf({0.0, 1.0}, 1.0));
  const auto opacity = [](double extinction) { return -std::expm1(-extinction * unitMm); };
  scene.transferFunction = {unitMm,
                            {{0.0, glm::dvec3(fromGrey), opacity(fromExtinction)},
                             {1.0, glm::dvec3(toGrey), opacity(toExtinction)}}};
  return scene;
}

// Mean grey (x) and mean extinction per mm (y) between pairs of scalars, in C++ and in GLSL.
struct Means {
  std::vector<glm::dvec2> cpu, gpu;
};

Means meansOf(const Scene& scene, const std::vector<glm::dvec2>& ends) {
  static const GlslEvaluator evaluate(
      {"stable_math.glsl", "piecewise.glsl", "classification.glsl", "preintegration.glsl"},
      "vec4 meanOf(float a, float b) { Material m = meanMaterial(a, b); return vec4(m.color, m.extinction); "
      "}");
  std::vector<glm::vec4> arguments;
  Means means;
  for (const glm::dvec2& pair : ends) {
    arguments.emplace_back(glm::vec2(pair), 0.0f, 0.0f);
    const MeanMaterial mean = meanMaterial(scene.transferFunction, pair.x, pair.y);
    means.cpu.emplace_back(mean.color.r, mean.extinction / unitMm);
  }
  for (const glm::vec4& texel : evaluate("meanOf(v.x, v.y)", arguments, scene))
    means.gpu.emplace_back(texel.r, texel.a / unitMm);
  return means;
}

// Alpha (y) and premultiplied grey (x) of pieces of equal length, front to back.
glm::dvec2 composited(const std::vector<glm::dvec2>& means, double lengthMm) {
  double grey = 0.0, transmittance = 1.0;
  for (const glm::dvec2& mean : means) {
    const double share = transmittance * oneMinusExpNeg(mean.y * lengthMm);
    grey += share * mean.x;
    transmittance -= share;
  }
  return {grey, 1.0 - transmittance};
}

} // namespace

// Closed form H1: alpha is exact. The colour of one segment is that of its mean material, as the definition
// says, and not I_exact, which weighs the front more because it hides the back: the difference falls with
// order 2 as the segment is divided. Without self-attenuation at all the colour would exceed alpha (H37).
void checkSegment(const json& one, CaseLedger& ledger) {
  const json& p = one["parameters"];
  const double ta = p["ta"], tb = p["tb"], ca = p["ca"], cb = p["cb"], length = p["d"];
  const Scene scene = segmentScene(ta, tb, ca, cb);
  std::vector<double> cpuErrors, gpuErrors;
  for (int pieces = 1; pieces <= 32; pieces *= 2) {
    std::vector<glm::dvec2> ends;
    for (int i = 0; i < pieces; ++i)
      ends.emplace_back(static_cast<double>(i) / pieces, (i + 1.0) / pieces);
    const Means means = meansOf(scene, ends);
    const glm::dvec2 cpu = composited(means.cpu, length / pieces);
    const glm::dvec2 gpu = composited(means.gpu, length / pieces);
    const std::string what = " of " + std::to_string(pieces);
    expectBoth(one, ledger, "alpha" + what, expectedFigure(one["expected"]["alpha"]), cpu.y, gpu.y);
    EXPECT_LE(cpu.x, cpu.y) << one["id"] << what;
    if (pieces == 1) {
      // The means of c τ and of τ for linear c and τ.
      const double mean = (ca * (2.0 * ta + tb) + cb * (ta + 2.0 * tb)) / (3.0 * (ta + tb));
      expectBoth(one, ledger, "mean colour", mean * expectedFigure(one["expected"]["alpha"]), cpu.x, gpu.x);
    }
    const double exact = expectedFigure(one["expected"]["I_exact"]);
    cpuErrors.push_back(std::abs(cpu.x - exact));
    gpuErrors.push_back(std::abs(gpu.x - exact));
  }
  std::cout << one["id"] << ": colour off by " << cpuErrors.front() << " in one segment, " << cpuErrors.back()
            << " in 32\n";
  // From 8 pieces on, each at most 1.2 deep.
  for (const std::vector<double>& errors : {cpuErrors, gpuErrors})
    for (const double order :
         observedOrders(std::vector<double>(errors.begin() + 3, errors.end()), 20.0 * 1e-6))
      ledger.expectWithin(one["id"], "order of the colour", order, 1.8, 2.2);
}

// Closed form H2: no quotient of differences where both ends are the same value, and none that loses digits
// where they are almost the same; the mean of a linear extinction between s ∓ δ is that at s.
void checkEqualEndpoints(const json& one, CaseLedger& ledger) {
  const double tau = one["parameters"]["tau"], length = one["parameters"]["d"];
  const Scene scene = segmentScene(0.0, 2.0 * tau, 0.5, 0.5);
  std::vector<glm::dvec2> ends{{0.5, 0.5}};
  for (int power = 1; power <= 23; ++power) {
    ends.emplace_back(0.5 - std::exp2(-power), 0.5 + std::exp2(-power));
    ends.emplace_back(0.5 + std::exp2(-power), 0.5 - std::exp2(-power));
  }
  const Means means = meansOf(scene, ends);
  for (std::size_t i = 0; i < ends.size(); ++i)
    expectBoth(one, ledger,
               "alpha between " + std::to_string(ends[i].x) + " and " + std::to_string(ends[i].y),
               expectedFigure(one["expected"]["alpha"]), composited({means.cpu[i]}, length).y,
               composited({means.gpu[i]}, length).y);
}

} // namespace limn::test
