// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/PointShare.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limn {
namespace {

TransferFunction fourPoints() {
  return {1.0, {{0, {1, 0, 0}, 0.0}, {100, {1, 0, 0}, 0.4}, {300, {1, 1, 1}, 0.8}, {500, {1, 1, 1}, 1.0}}};
}

TEST(PointShare, isAllAtThePointAndFallsEvenlyToItsNeighbours) {
  const TransferFunction function = fourPoints();
  EXPECT_EQ(shareOfPoint(function, 1, 100.0), 1.0);
  EXPECT_EQ(shareOfPoint(function, 1, 50.0), 0.5);
  EXPECT_EQ(shareOfPoint(function, 1, 250.0), 0.25);
  EXPECT_EQ(shareOfPoint(function, 1, 0.0), 0.0);
  EXPECT_EQ(shareOfPoint(function, 1, 300.0), 0.0);
  EXPECT_EQ(shareOfPoint(function, 1, 400.0), 0.0);
}

TEST(PointShare, ofTheFirstAndTheLastReachesToTheEnds) {
  const TransferFunction function = fourPoints();
  EXPECT_EQ(shareOfPoint(function, 0, -1e6), 1.0);
  EXPECT_EQ(shareOfPoint(function, 0, 25.0), 0.75);
  EXPECT_EQ(shareOfPoint(function, 3, 1e6), 1.0);
  EXPECT_EQ(shareOfPoint({1.0, {{7, {}, 0.5}}}, 0, -3.0), 1.0);
}

TEST(PointShare, ofPointsAtOneValueIsDividedAtTheStep) {
  const TransferFunction step{1.0, {{0, {}, 0.0}, {100, {}, 0.1}, {100, {}, 0.9}, {200, {}, 1.0}}};
  EXPECT_EQ(shareOfPoint(step, 1, 50.0), 0.5);
  EXPECT_EQ(shareOfPoint(step, 1, 100.0), 0.0) << "there the last one holds";
  EXPECT_EQ(shareOfPoint(step, 1, 150.0), 0.0);
  EXPECT_EQ(shareOfPoint(step, 2, 50.0), 0.0);
  EXPECT_EQ(shareOfPoint(step, 2, 100.0), 1.0);
  EXPECT_EQ(shareOfPoint(step, 2, 150.0), 0.5);
}

TEST(PointShare, ofAllPointsTogetherIsOneEverywhere) {
  const TransferFunction function = fourPoints();
  for (double value = -50.0; value <= 600.0; value += 12.5) {
    double sum = 0.0;
    for (std::size_t point = 0; point < function.points.size(); ++point)
      sum += shareOfPoint(function, point, value);
    EXPECT_NEAR(sum, 1.0, 1e-15) << value;
  }
}

TEST(PointShare, emphasisKeepsThePointAndFadesTheRest) {
  const TransferFunction function = fourPoints();
  const TransferFunction lit = withPointEmphasised(function, 1);
  EXPECT_EQ(classify(lit, 100.0).opacity, 0.4);
  EXPECT_EQ(classify(lit, 100.0).color, emphasisColor);
  // Elsewhere grey, 0.08 as opaque; transparent stays transparent.
  const Classified dense = classify(lit, 500.0);
  EXPECT_NEAR(dense.opacity, 0.08, 1e-15);
  EXPECT_EQ(dense.color.r, dense.color.g);
  EXPECT_EQ(classify(lit, -10.0).opacity, 0.0);
  // Half-way opacity and share are products: 0.6 · (0.08 + 0.92 · 0.5).
  EXPECT_NEAR(classify(lit, 200.0).opacity, 0.324, 1e-12);
  // Between the parts a chord: the product bends by 2 · 0.4 · 0.92 over the piece, of which an eighth is off
  // by an eighth, squared.
  EXPECT_NEAR(classify(lit, 187.5).opacity, (0.4 + 0.4 * 0.4375) * (0.08 + 0.92 * 0.5625),
              0.4 * 0.92 / 4.0 / 64.0 + 1e-12);
}

TEST(PointShare, emphasisShowsWhatIsFaintAndNothingThatIsTransparent) {
  const TransferFunction faint{1.0, {{0, {}, 0.0}, {100, {}, 0.01}, {200, {}, 1.0}}};
  EXPECT_EQ(classify(withPointEmphasised(faint, 1), 100.0).opacity, 0.25);
  EXPECT_EQ(classify(withPointEmphasised(faint, 0), -50.0).opacity, 0.0);
  EXPECT_EQ(classify(withPointEmphasised(faint, 0), 0.0).opacity, 0.0);
}

TEST(PointShare, emphasisOfAStepKeepsTheStep) {
  const TransferFunction step{1.0, {{0, {}, 0.0}, {100, {}, 0.1}, {100, {}, 0.9}, {200, {}, 1.0}}};
  const TransferFunction lit = withPointEmphasised(step, 2);
  EXPECT_NEAR(classify(lit, 99.999).opacity, 0.008, 1e-4);
  EXPECT_EQ(classify(lit, 100.0).opacity, 0.9);
  EXPECT_TRUE(std::ranges::is_sorted(lit.points, {}, &ControlPoint::value));
}

} // namespace
} // namespace limn
