// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/FigureText.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

DecisionCost costOf(const char* name, bool isDefault, double p99_9, double mean, double timesDefault,
                    double extraMb) {
  DecisionCost cost;
  cost.group = "gradient";
  cost.name = name;
  cost.isDefault = isDefault;
  cost.error.p99_9 = cost.fineError.p99_9 = p99_9;
  cost.error.mean = cost.fineError.mean = mean;
  cost.timesDefault = timesDefault;
  cost.extraMb = extraMb;
  return cost;
}

const DecisionCost own = costOf("on the fly", true, 1.0, 0.05, 1.0, 0.0);

TEST(DecisionVerdict, namesWhatIsFasterAndAsAccurate) {
  const auto verdict = verdictOn({own, costOf("stored", false, 1.1, 0.054, 0.75, 58.6)});
  ASSERT_EQ(verdict.size(), 1u);
  EXPECT_EQ(verdict[0], "Another way would be faster here and as accurate: gradient, stored, in 75 % of the "
                        "time, with 58.6 MB more of graphics memory.");
}

TEST(DecisionVerdict, doesNotNameWhatIsLessAccurateOrHardlyFaster) {
  DecisionCost coarse = costOf("wrong at the scene's step", false, 1.0, 0.05, 0.5, 0.0);
  coarse.error.p99_9 = 1.2;
  DecisionCost fine = costOf("wrong at a fine step", false, 1.0, 0.05, 0.5, 0.0);
  fine.fineError.mean = 0.06;
  const auto verdict = verdictOn({own, coarse, fine, costOf("as slow", false, 1.0, 0.05, 0.95, -10.0)});
  ASSERT_EQ(verdict.size(), 1u);
  EXPECT_EQ(verdict[0], "No other way of any decision was as accurate here and faster by a tenth.");
}

TEST(DecisionVerdict, saysNothingOfNothing) {
  EXPECT_TRUE(verdictOn({}).empty());
}

} // namespace
} // namespace limn
