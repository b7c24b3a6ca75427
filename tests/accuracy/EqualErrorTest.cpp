// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/times/Timing.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

// Half the step takes twice the time and errs by half: time times error is 8.
const std::vector<ErrorAndTime> halvedSteps{{4.0, 2.0}, {2.0, 4.0}, {1.0, 8.0}};

TEST(EqualError, liesBetweenNeighboursOfACurve) {
  EXPECT_NEAR(*timeAtError(halvedSteps, 1.6), 8.0 / 1.6, 1e-12);
  EXPECT_NEAR(*timeAtError(halvedSteps, 1.0), 8.0, 1e-12);
}

TEST(EqualError, isTheCoarsestPicturesWhereThatIsCloseEnough) {
  EXPECT_DOUBLE_EQ(*timeAtError(halvedSteps, 10.0), 2.0);
}

TEST(EqualError, isNeverReachedByACurveThatStaysAbove) {
  EXPECT_FALSE(timeAtError(halvedSteps, 0.5));
}

TEST(EqualError, takesTheFasterOfTwoWays) {
  std::vector<ErrorAndTime> curve = halvedSteps;
  curve.push_back({1.0, 3.0}); // steps of another kind
  EXPECT_NEAR(*timeAtError(curve, 1.0), 3.0, 1e-12);
}

} // namespace
} // namespace limn
