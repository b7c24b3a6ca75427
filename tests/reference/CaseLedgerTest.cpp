// SPDX-License-Identifier: GPL-3.0-or-later
// What the completeness of the analytic tests rests on.
#include "support/CaseLedger.h"

#include <gtest/gtest-spi.h>

namespace limn {
namespace {

const auto every = [](const nlohmann::json&) { return true; };

TEST(CaseLedger, failsForACaseThatNothingCompared) {
  static const nlohmann::json cases = {{{"id", "compared"}}, {{"id", "forgotten"}}};
  static test::CaseLedger ledger;
  ledger.expectNear("compared", "figure", 1.0, 1.0, 0.0);
  EXPECT_NONFATAL_FAILURE(ledger.expectEvery(cases, every), "forgotten");
  ledger.expectWithin("forgotten", "order", 2.0, 1.8, 2.2);
  ledger.expectEvery(cases, every);
}

TEST(CaseLedger, failsWhereNoCaseIsMeant) {
  static const nlohmann::json cases = nlohmann::json::array();
  static test::CaseLedger ledger;
  EXPECT_NONFATAL_FAILURE(ledger.expectEvery(cases, every), "none of the cases");
}

TEST(CaseLedger, failsForAFigureBeyondItsTolerance) {
  static test::CaseLedger ledger;
  EXPECT_NONFATAL_FAILURE(ledger.expectNear("id", "figure", 1.0, 1.1, 0.05), "id figure");
  EXPECT_NONFATAL_FAILURE(ledger.expectWithin("id", "order", 1.0, 1.8, 2.2), "id order");
}

} // namespace
} // namespace limn
