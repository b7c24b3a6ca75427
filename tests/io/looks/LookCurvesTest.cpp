// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"

#include "io/looks/curves/LookCurves.h"

#include <random>

namespace limn {
namespace {

using test::largestDifference;

const glm::dvec3 pureRed{1.0, 0.0, 0.0}, pureBlue{0.0, 0.0, 1.0}, pureWhite{1.0};

TEST(LookCurves, aMergedFunctionHasBothCurvesExactly) {
  const std::vector<ControlPoint> opacity{
      {0.0, pureWhite, 0.0}, {30.0, pureWhite, 0.9}, {70.0, pureWhite, 0.2}};
  const std::vector<ControlPoint> color{{-20.0, pureRed, 0.0}, {50.0, pureBlue, 0.0}, {90.0, pureWhite, 0.0}};
  const TransferFunction function = merged(opacity, color);
  EXPECT_EQ(function.points.size(), 6u);
  const auto expected = [&](double value) {
    return Classified{classify({1.0, color}, value).color, classify({1.0, opacity}, value).opacity};
  };
  EXPECT_LE(largestDifference(function, expected, -40.0, 110.0), 1e-12);
}

TEST(LookCurves, stepsOfEitherCurveStaySteps) {
  const std::vector<ControlPoint> opacity{
      {0.0, pureWhite, 0.1}, {50.0, pureWhite, 0.1}, {50.0, pureWhite, 0.8}, {90.0, pureWhite, 0.8}};
  const std::vector<ControlPoint> color{
      {0.0, pureRed, 0.0}, {20.0, pureRed, 0.0}, {20.0, pureBlue, 0.0}, {90.0, pureBlue, 0.0}};
  const TransferFunction function = merged(opacity, color);
  EXPECT_EQ(classify(function, std::nextafter(50.0, 0.0)).opacity, 0.1);
  EXPECT_EQ(classify(function, 50.0).opacity, 0.8);
  EXPECT_EQ(classify(function, std::nextafter(20.0, 0.0)).color, pureRed);
  EXPECT_EQ(classify(function, 20.0).color, pureBlue) << "a step takes the colour on its right";
}

TEST(LookCurves, whereBothStepAtOneValueEachSideKeepsItsOwn) {
  const std::vector<ControlPoint> opacity{{10.0, pureWhite, 0.2}, {10.0, pureWhite, 0.6}};
  const std::vector<ControlPoint> color{{10.0, pureRed, 0.0}, {10.0, pureBlue, 0.0}};
  const TransferFunction function = merged(opacity, color);
  ASSERT_EQ(function.points.size(), 2u);
  EXPECT_EQ(function.points[0], (ControlPoint{10.0, pureRed, 0.2}));
  EXPECT_EQ(function.points[1], (ControlPoint{10.0, pureBlue, 0.6}));
}

TEST(LookCurves, differentEndsAreTold) {
  const std::vector<ControlPoint> opacity{{0.0, pureWhite, 0.0}, {952.0, pureWhite, 1.0}};
  std::vector<Message> changes;
  merged(opacity, {{0.0, pureRed, 0.0}, {952.0, pureBlue, 0.0}}, changes);
  EXPECT_TRUE(changes.empty());
  merged(opacity, {{0.0, pureRed, 0.0}, {953.0, pureBlue, 0.0}}, changes);
  EXPECT_TRUE(test::isTold(changes, "end at different values"));
}

TEST(LookCurves, aHundredThousandPointsAtOneValueAreMergedInTime) {
  // A quadratic walk would take 10^10 steps.
  const std::vector<ControlPoint> many(mostLookPoints, {5.0, pureRed, 0.5});
  EXPECT_EQ(merged(many, many).points.size(), mostLookPoints);
}

TEST(LookCurves, simplifyingKeepsWithinTheToleranceAndKeepsSteps) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-0.003, 0.003);
  std::vector<ControlPoint> points;
  for (int i = 0; i <= 4000; ++i) {
    const double u = i / 4000.0;
    points.push_back({u, glm::dvec3(u * u, 0.5 + noise(random), 1.0 - u), 0.5 + 0.4 * std::sin(9.0 * u)});
    if (i == 1234)
      points.push_back({u, pureRed, 0.0});
  }
  const double tolerance = 0.01;
  const std::vector<ControlPoint> kept = simplified(points, tolerance);
  EXPECT_LT(kept.size(), 60u)
      << "a sine of 1.4 periods needs some 8 pieces a period, noise and the step a few more";
  const TransferFunction function{1.0, kept};
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i != 1234) // at a step the last one holds
      largest = std::max(largest, test::difference(classify(function, points[i].value),
                                                   {points[i].color, points[i].opacity}));
  EXPECT_LE(largest, tolerance + 1e-12);
}

TEST(LookCurves, aStraightLineNeedsItsEndsAlone) {
  std::vector<ControlPoint> points;
  for (int i = 0; i <= 1000; ++i)
    points.push_back({double(i), glm::dvec3(i / 1000.0), 0.25});
  EXPECT_EQ(simplified(points, 1e-9).size(), 2u);
}

TEST(LookCurves, joinedCurvesAreClearOutsideAndTheMostOpaqueWhereTheyOverlap) {
  const std::vector<ControlPoint> a{{0.0, pureRed, 0.2}, {100.0, pureRed, 0.8}};
  const std::vector<ControlPoint> b{{50.0, pureBlue, 0.9}, {150.0, pureBlue, 0.1}};
  const std::vector<ControlPoint> c{{200.0, pureWhite, 0.3}, {300.0, pureWhite, 0.3}};
  bool overlap = false;
  const TransferFunction function = joined({a, b, c}, &overlap);
  EXPECT_TRUE(overlap);
  const auto within = [](const std::vector<ControlPoint>& curve, double value) {
    return value >= curve.front().value && value < curve.back().value ? classify({1.0, curve}, value).opacity
                                                                      : 0.0;
  };
  double largest = 0.0;
  for (int i = 0; i <= 4001; ++i) {
    const double value = -50.0 + i * 0.1;
    const double expected = std::max({within(a, value), within(b, value), within(c, value)});
    largest = std::max(largest, std::abs(classify(function, value).opacity - expected));
  }
  EXPECT_LE(largest, 1e-9);
  // 0.2 + 0.006 x = 0.9 - 0.008 (x - 50) at x = 78.571…
  EXPECT_EQ(classify(function, 78.0).color, pureBlue);
  EXPECT_EQ(classify(function, 79.0).color, pureRed);
  EXPECT_EQ(classify(function, 120.0).color, pureBlue);
}

TEST(LookCurves, curvesThatTouchDoNotOverlap) {
  bool overlap = true;
  const TransferFunction function =
      joined({{{0.0, pureRed, 0.5}, {100.0, pureRed, 0.5}}, {{100.0, pureBlue, 0.7}, {200.0, pureBlue, 0.0}}},
             &overlap);
  EXPECT_FALSE(overlap);
  EXPECT_EQ(classify(function, 99.9).color, pureRed);
  EXPECT_EQ(classify(function, 100.0).color, pureBlue);
  EXPECT_EQ(classify(function, -1.0).opacity, 0.0);
  EXPECT_EQ(classify(function, 201.0).opacity, 0.0);
}

} // namespace
} // namespace limn
