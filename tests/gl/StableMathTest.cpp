// SPDX-License-Identifier: GPL-3.0-or-later
// The helpers of shaders/stable_math.glsl against their twins in double, each over its whole range: a
// fragment program draws one value per pixel into a target of floats.
#include "scene/basics/StableMath.h"
#include "glsl/programs/GlslEvaluator.h"
#include "support/GlTest.h"

#include <functional>

namespace limn {
namespace {

// Arguments from `low` to `high` in equal ratios.
std::vector<glm::vec4> geometric(double low, double high, const glm::vec3& rest = glm::vec3(0.0f)) {
  std::vector<glm::vec4> arguments;
  for (int i = 0; i <= 1000; ++i)
    arguments.emplace_back(static_cast<float>(low * std::pow(high / low, i / 1000.0)), rest.x, rest.y,
                           rest.z);
  return arguments;
}

std::vector<glm::vec4> linear(double low, double high, const glm::vec3& rest = glm::vec3(0.0f)) {
  std::vector<glm::vec4> arguments;
  for (int i = 0; i <= 1000; ++i)
    arguments.emplace_back(static_cast<float>(low + (high - low) * i / 1000.0), rest.x, rest.y, rest.z);
  return arguments;
}

class StableMath : public test::GlTest {
protected:
  // |GLSL - double| ≤ absolute + relative · |double|, the double taking the same float arguments.
  void compare(const std::string& expression, const std::vector<glm::vec4>& arguments,
               const std::function<double(const glm::dvec4&)>& twin, double relative, double absolute = 0.0) {
    const std::vector<glm::vec4> values = m_evaluate(expression, arguments);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const double expected = twin(glm::dvec4(arguments[i]));
      EXPECT_NEAR(values[i].x, expected, absolute + relative * std::abs(expected))
          << expression << " of " << arguments[i].x << ", " << arguments[i].y << ", " << arguments[i].z;
    }
  }

  double value(const std::string& expression, const glm::dvec4& argument) {
    return m_evaluate(expression, {glm::vec4(argument)})[0].x;
  }

private:
  GlslEvaluator m_evaluate{{"stable_math.glsl"}};
};

TEST_F(StableMath, oneMinusExpNegKeepsItsDigitsFromTinyToLarge) {
  // exp2 of llvmpipe is good to 2.3e-7 relative (HARD_CASES section 1); at the series' end 1 - e^-x is a
  // quarter of it.
  const auto twin = [](const glm::dvec4& v) { return oneMinusExpNeg(v.x); };
  compare("oneMinusExpNeg(v.x)", geometric(1e-30, 100.0), twin, 2e-6);
  compare("oneMinusExpNeg(v.x)", {glm::vec4(0.0f), glm::vec4(1e30f)}, twin, 2e-7);
}

TEST_F(StableMath, theMeansOfAPieceKeepTheirDigitsFromTinyToOpaque) {
  // Both forms lose up to two bits where they meet, at a quarter.
  const auto mean = [](const glm::dvec4& v) { return meanMinusLog1m(v.x); };
  const auto moment = [](const glm::dvec4& v) { return momentMinusLog1m(v.x); };
  for (const auto& arguments : {geometric(1e-30, 0.999), linear(0.0, 1.0 - 1e-6)}) {
    compare("meanMinusLog1m(v.x)", arguments, mean, 2e-6);
    compare("momentMinusLog1m(v.x)", arguments, moment, 8e-6);
  }
  // Simpson's rule with 2000 intervals, exact to 1e-12 for these smooth integrands.
  for (const double x : {0.01, 0.019, 0.021, 0.3, 0.7}) {
    double sum = 0.0;
    double weighted = 0.0;
    for (int i = 0; i <= 2000; ++i) {
      const double s = i / 2000.0;
      const double weight = (i == 0 || i == 2000 ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) / 6000.0;
      sum -= weight * std::log1p(-x * s);
      weighted -= weight * s * std::log1p(-x * s);
    }
    EXPECT_NEAR(meanMinusLog1m(x), sum, 1e-12) << x;
    EXPECT_NEAR(momentMinusLog1m(x), weighted, 1e-11) << x;
  }
}

TEST_F(StableMath, minusLog1mOpacityKeepsItsDigitsFromTinyToOpaque) {
  const auto twin = [](const glm::dvec4& v) { return minusLog1mOpacity(v.x); };
  compare("minusLog1mOpacity(v.x)", geometric(1e-30, 1.0), twin, 1e-6);
  compare("minusLog1mOpacity(v.x)", linear(0.4, 1.0), twin, 1e-6);
  compare("minusLog1mOpacity(v.x)", {glm::vec4(0.0f), glm::vec4(-1.0f), glm::vec4(2.0f)}, twin, 1e-6);
}

TEST_F(StableMath, safeNormalIsAUnitVectorFromTinyToHuge) {
  // Components below 1e-38 are flushed to 0 on graphics cards.
  std::vector<glm::vec4> arguments;
  for (const double size : {1e-34, 1e-20, 1e-10, 1.0, 1e10, 1e20, 1e37})
    for (int i = 0; i < 60; ++i)
      arguments.emplace_back(glm::vec3(glm::dvec3(std::sin(i), std::cos(2.0 * i), std::sin(3.0 * i)) * size),
                             0);
  const auto component = [](int c) {
    return [c](const glm::dvec4& v) { return safeNormal(glm::dvec3(v))[c]; };
  };
  compare("safeNormal(v.xyz).x", arguments, component(0), 0.0, 4e-7);
  compare("safeNormal(v.xyz).y", arguments, component(1), 0.0, 4e-7);
  compare("safeNormal(v.xyz).z", arguments, component(2), 0.0, 4e-7);
  compare("safeNormal(v.xyz).w", arguments, component(3), 4e-7);
  EXPECT_EQ(value("length(safeNormal(v.xyz))", glm::dvec4(0.0)), 0.0);
}

TEST_F(StableMath, blinnTermHasNoEdgeCases) {
  for (const double exponent : {1e-6, 0.5, 1.0, 5.0, 32.0, 128.0, 1024.0}) {
    const auto twin = [](const glm::dvec4& v) { return blinnTerm(v.x, v.y); };
    const glm::vec3 rest(static_cast<float>(exponent), 0.0f, 0.0f);
    compare("blinnTerm(v.x, v.y)", linear(-1.0, 1.0, rest), twin, 2e-6, 1e-6);
    compare("blinnTerm(v.x, v.y)", linear(0.99, 1.0001, rest), twin, 2e-6, 1e-6);
  }
  // H2: 0⁰ and negative bases.
  EXPECT_EQ(value("blinnTerm(v.x, v.y)", {0.0, 0.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(value("blinnTerm(v.x, v.y)", {-1e-7, 1e4, 0.0, 0.0}), 0.0);
  EXPECT_EQ(value("blinnTerm(v.x, v.y)", {1.0000001, 1e4, 0.0, 0.0}), 1.0);
}

TEST_F(StableMath, theKneeIsTheIdentityBelowAndStaysUnderOneAbove) {
  const auto twin = [](const glm::dvec4& v) { return knee(glm::dvec3(v), v.w).x; };
  compare("knee(v.xyz, v.w).x", linear(0.0, 4.0, {0.3f, 1.2f, 0.8f}), twin, 1e-6);
  EXPECT_EQ(value("knee(v.xyz, v.w).x", {0.7, 0.3, 0.1, 0.8}), 0.7f);
}

TEST_F(StableMath, logOnePlusKeepsItsDigitsFromTinyToLarge) {
  const auto twin = [](const glm::dvec4& v) { return logOnePlus(v.x); };
  compare("logOnePlus(v.x)", geometric(1e-30, 1e6), twin, 1e-6);
}

TEST_F(StableMath, curvesAndWeightsMatch) {
  compare(
      "gammaCurve(v.x, v.y)", linear(0.0, 1.0, {0.5f, 0.0f, 0.0f}),
      [](const glm::dvec4& v) { return gammaCurve(v.x, v.y); }, 1e-6, 1e-7);
  compare(
      "gammaCurve(v.x, v.y)", linear(0.0, 1.0, {2.2f, 0.0f, 0.0f}),
      [](const glm::dvec4& v) { return gammaCurve(v.x, v.y); }, 2e-6, 1e-7);
  for (const float b : {0.01f, 1.0f, 9.0f, 99.0f, 1e4f})
    compare(
        "logCurve(v.x, v.y)", linear(0.0, 1.0, {b, 0.0f, 0.0f}),
        [](const glm::dvec4& v) { return logCurve(v.x, v.y); }, 2e-6, 2e-7);
  compare(
      "significanceWeight(v.y, v.z, v.x)", linear(0.0, 1.0, {0.05f, 0.25f, 0.0f}),
      [](const glm::dvec4& v) { return significanceWeight(v.y, v.z, v.x); }, 1e-6, 1e-6);
  compare(
      "significanceWeight(v.y, v.z, v.x)", linear(0.0, 1.0, {0.5f, 0.5f, 0.0f}),
      [](const glm::dvec4& v) { return significanceWeight(v.y, v.z, v.x); }, 0.0);
  compare(
      "energyFactor(v.x, v.y)", linear(0.1, 1024.0, {1024.0f, 0.0f, 0.0f}),
      [](const glm::dvec4& v) { return energyFactor(v.x, v.y); }, 3e-7);
  compare(
      "mapped(v.x, v.y, v.z)", linear(0.0, 1.0, {5.0f, 125.0f, 0.0f}),
      [](const glm::dvec4& v) { return mapped(v.x, v.y, v.z); }, 3e-7);
}

TEST_F(StableMath, fogFactorsMatch) {
  compare(
      "fogLinear(v.x, v.y, v.z)", linear(-1.0, 8.0, {1.0f, 5.0f, 0.0f}),
      [](const glm::dvec4& v) { return fogLinear(v.x, v.y, v.z); }, 0.0, 2e-7);
  compare(
      "fogLinear(v.x, v.y, v.z)", linear(-1.0, 8.0, {3.0f, 3.0f, 0.0f}),
      [](const glm::dvec4& v) { return fogLinear(v.x, v.y, v.z); }, 0.0);
  compare(
      "fogExp(v.x, v.y, v.z)", linear(-1.0, 30.0, {1.0f, 0.35f, 0.0f}),
      [](const glm::dvec4& v) { return fogExp(v.x, v.y, v.z); }, 2e-6, 1e-7);
  compare(
      "fogExp2(v.x, v.y, v.z)", linear(-1.0, 30.0, {1.0f, 0.35f, 0.0f}),
      [](const glm::dvec4& v) { return fogExp2(v.x, v.y, v.z); }, 2e-6, 1e-7);
}

} // namespace
} // namespace limn
