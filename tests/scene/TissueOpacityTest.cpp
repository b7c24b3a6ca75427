// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/TissueOpacity.h"

#include <gtest/gtest.h>

// More or less opacity around a value.

namespace limn {
namespace {

const TransferFunction ramp{1.0, {{0.0, {0, 0, 0}, 0.0}, {1000.0, {1, 1, 1}, 1.0}}};

double opacityAt(const TransferFunction& function, double value) {
  return classify(function, value).opacity;
}

TEST(TissueOpacity, changesTheBandAndNothingBeyondItsFlanks) {
  const TransferFunction less = withOpacityChanged(ramp, {400.0, 600.0}, lessOpacity);
  EXPECT_EQ(normalised(less), less) << "ascending";
  for (const double value : {0.0, 100.0, 300.0, 700.0, 900.0, 1000.0})
    EXPECT_DOUBLE_EQ(opacityAt(less, value), opacityAt(ramp, value)) << value;
  for (const double value : {400.0, 500.0, 600.0})
    EXPECT_DOUBLE_EQ(opacityAt(less, value), opacityAt(ramp, value) / 2.0) << value;
  EXPECT_NEAR(opacityAt(less, 350.0), (0.3 + 0.2) / 2.0, 1e-12) << "a line from 300 to 400";
  for (const double value : {350.0, 500.0, 650.0})
    EXPECT_NEAR(classify(less, value).color.r, value / 1000.0, 1e-12) << "colours stay";
}

TEST(TissueOpacity, pointsOnAFlankTakePartOfTheChange) {
  TransferFunction function = ramp;
  function.points.insert(function.points.begin() + 1, {350.0, {1, 0, 0}, 0.8});
  const TransferFunction less = withOpacityChanged(function, {400.0, 600.0}, lessOpacity);
  EXPECT_DOUBLE_EQ(opacityAt(less, 350.0), 0.6) << "half of the way to 0.4";
}

TEST(TissueOpacity, againAndAgainAddsNoFurtherPoints) {
  TransferFunction function = withOpacityChanged(ramp, {400.0, 600.0}, lessOpacity);
  const std::size_t points = function.points.size();
  for (int n = 0; n < 6; ++n)
    function = withOpacityChanged(function, {400.0, 600.0}, lessOpacity);
  EXPECT_EQ(function.points.size(), points);
  EXPECT_EQ(opacityAt(function, 500.0), 0.0) << "hardly seen, then not at all";
  for (int n = 0; n < 8; ++n)
    function = withOpacityChanged(function, {400.0, 600.0}, moreOpacity);
  EXPECT_EQ(opacityAt(function, 500.0), 1.0);
}

TEST(TissueOpacity, raisesFromNothing) {
  const TransferFunction more = withOpacityChanged({1.0, {}}, {10.0, 20.0}, moreOpacity);
  EXPECT_DOUBLE_EQ(opacityAt(more, 15.0), 0.05);
  EXPECT_EQ(opacityAt(more, 0.0), 0.0);
  EXPECT_EQ(opacityAt(more, 30.0), 0.0);
  const TransferFunction one = withOpacityChanged({1.0, {{5.0, {1, 1, 1}, 0.5}}}, {5.0, 5.0}, moreOpacity);
  EXPECT_EQ(opacityAt(one, 5.0), 1.0) << "a band of one value";
}

} // namespace
} // namespace limn
