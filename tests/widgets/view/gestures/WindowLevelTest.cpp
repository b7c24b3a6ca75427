// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/ViewDrag.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

const ValueRange heldValues{-1000.0, 2000.0};

TransferFunction ramp() {
  return {.points = {{100, {1, 0, 0}, 0.0}, {200, {0, 1, 0}, 0.25}, {300, {0, 0, 1}, 0.5}}};
}

TEST(WindowLevel, isTheSpanOfTheFunctionsPoints) {
  const FunctionWindow window = windowOf(ramp(), heldValues);
  EXPECT_EQ(window.level, 200.0);
  EXPECT_EQ(window.width, 200.0);
}

TEST(WindowLevel, isTheVolumesRangeWhereTheFunctionHasNoWidth) {
  EXPECT_EQ(windowOf(TransferFunction{}, heldValues).width, 3000.0);
  EXPECT_EQ(windowOf({.points = {{5, {}, 0.1}, {5, {}, 0.9}}}, heldValues).level, 500.0);
}

TEST(WindowLevel, draggingRightWidensAboutTheMiddle) {
  const TransferFunction wider = windowLevelDragged(ramp(), heldValues, {256.0, 0.0});
  EXPECT_NEAR(wider.points[0].value, 200.0 - 100.0 * std::exp(1.0), 1e-9);
  EXPECT_NEAR(wider.points[1].value, 200.0, 1e-9);
}

TEST(WindowLevel, draggingUpRaisesTheLevelByTheWidthOver256Pixels) {
  const TransferFunction higher = windowLevelDragged(ramp(), heldValues, {0.0, -256.0});
  EXPECT_NEAR(higher.points[0].value, 300.0, 1e-9);
  EXPECT_NEAR(higher.points[2].value, 500.0, 1e-9);
}

TEST(WindowLevel, noMovementChangesNothing) {
  EXPECT_EQ(windowLevelDragged(ramp(), heldValues, {0.0, 0.0}), ramp());
  EXPECT_EQ(opacityDragged(ramp(), {40.0, 0.0}), ramp());
}

TEST(WindowLevel, aWildDragKeepsThePointsFiniteAndInOrder) {
  const TransferFunction wild = windowLevelDragged(ramp(), heldValues, {-1e6, 1e5});
  EXPECT_LT(wild.points[0].value, wild.points[1].value);
  EXPECT_TRUE(std::isfinite(wild.points[2].value));
}

TEST(Opacity, draggingUpByAHundredPixelsDoublesItAndKeepsZero) {
  const TransferFunction denser = opacityDragged(ramp(), {0.0, -100.0});
  EXPECT_EQ(denser.points[0].opacity, 0.0);
  EXPECT_NEAR(denser.points[1].opacity, 0.5, 1e-12);
  EXPECT_NEAR(denser.points[2].opacity, 1.0, 1e-12);
}

} // namespace
} // namespace limn
