// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/TransferFunction.h"

#include "scene/basics/Error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

const TransferFunction blackToOrange{1.0, {{0.0, {0, 0, 0}, 0.0}, {100.0, {1, 0.5, 0}, 1.0}}};

TEST(TransferFunction, isLinearBetweenPointsAndConstantOutside) {
  EXPECT_DOUBLE_EQ(classify(blackToOrange, 25.0).opacity, 0.25);
  EXPECT_DOUBLE_EQ(classify(blackToOrange, 50.0).color.g, 0.25);
  EXPECT_DOUBLE_EQ(classify(blackToOrange, -5.0).opacity, 0.0);
  EXPECT_DOUBLE_EQ(classify(blackToOrange, 500.0).opacity, 1.0);
}

TEST(TransferFunction, takesTheLastPointAtTheValueOfAStep) {
  const TransferFunction step{1.0,
                              {{0, {}, 0.0}, {10, {}, 0.0}, {10, {}, 0.4}, {10, {}, 0.8}, {20, {}, 0.8}}};
  EXPECT_DOUBLE_EQ(classify(step, std::nextafter(10.0, 0.0)).opacity, 0.0);
  EXPECT_DOUBLE_EQ(classify(step, 10.0).opacity, 0.8);
}

TEST(TransferFunction, isTransparentWithoutPoints) {
  EXPECT_EQ(classify(TransferFunction{}, 3.0).opacity, 0.0);
}

TEST(TransferFunction, movingAPointStopsAtItsNeighbours) {
  const TransferFunction three = withPointAdded(blackToOrange, 50.0, 0.5);
  EXPECT_EQ(withPointMoved(three, 1, 400.0, 2.0).points[1].value, 100.0);
  EXPECT_EQ(withPointMoved(three, 1, 400.0, 2.0).points[1].opacity, 1.0);
  EXPECT_EQ(withPointMoved(three, 1, -400.0, 0.5).points[1].value, 0.0);
}

TEST(TransferFunction, addingAPointOnTheCurveChangesNoValue) {
  std::size_t index = 99;
  const TransferFunction edited = withPointAdded(blackToOrange, 30.0, 0.3, &index);
  EXPECT_EQ(index, 1u);
  for (double value = -10.0; value <= 110.0; value += 7.0) {
    EXPECT_NEAR(classify(edited, value).opacity, classify(blackToOrange, value).opacity, 1e-15);
    EXPECT_NEAR(classify(edited, value).color.g, classify(blackToOrange, value).color.g, 1e-15);
  }
}

TEST(TransferFunction, extinctionIsFiniteAtFullOpacityAndExactNearZero) {
  // -log1p(-(1 - 2^-24)) = 24 ln 2.
  EXPECT_NEAR(extinctionPerMm(1.0, 1.0), 24.0 * std::log(2.0), 1e-12);
  EXPECT_NEAR(extinctionPerMm(1e-9, 2.0), 0.5e-9, 1e-18);
}

TEST(TransferFunction, normalisingSortsStablyAndRefusesNan) {
  const TransferFunction unsorted{1.0, {{10, {}, 0.1}, {0, {}, 2.0}, {10, {}, 0.9}}};
  const TransferFunction sorted = normalised(unsorted);
  EXPECT_EQ(sorted.points[0].opacity, 1.0);
  EXPECT_EQ(sorted.points[1].opacity, 0.1);
  EXPECT_EQ(sorted.points[2].opacity, 0.9);
  EXPECT_THROW(normalised({1.0, {{std::nan(""), {}, 0.5}}}), Error);
}

TEST(TransferFunction, scalingOpacityKeepsZeroAtZero) {
  const TransferFunction scaled = withOpacityScaled(blackToOrange, 3.0);
  EXPECT_EQ(scaled.points[0].opacity, 0.0);
  EXPECT_EQ(scaled.points[1].opacity, 1.0);
}

} // namespace
} // namespace limn
