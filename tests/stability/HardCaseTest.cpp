// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/Workbench.h"
#include "stability/cases/Cases.h"
#include "support/GlTest.h"

#include <cmath>
#include <iostream>
#include <limits>
#include <set>

namespace limn {

// How a failed case names itself in the output of a test.
void PrintTo(const HardCase& one, std::ostream* stream) {
  *stream << one.id;
}

namespace {

class HardCases : public test::GlTest, public testing::WithParamInterface<HardCase> {};

TEST_P(HardCases, holds) {
  Workbench bench;
  const std::vector<MeasuredCase> measured = measure({GetParam()}, bench);
  ASSERT_FALSE(measured[0].findings.empty());
  for (const Finding& finding : measured[0].findings) {
    std::cout << GetParam().id << " " << finding.engine << " | " << finding.what << " | " << finding.figure
              << " of " << finding.bound << "\n";
    EXPECT_NE(finding.verdict, Verdict::fail)
        << finding.engine << ", " << finding.what << ": " << finding.figure << " exceeds " << finding.bound
        << " (" << finding.reason << ")";
    EXPECT_FALSE(finding.reason.empty()) << finding.engine << ", " << finding.what;
  }
}

INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::ValuesIn(hardCases()),
                         [](const testing::TestParamInfo<HardCase>& one) { return one.param.id; });

TEST(Findings, aFigureThatIsNoNumberFails) {
  EXPECT_EQ(atMost("gl", "", std::nan(""), 1.0, "").verdict, Verdict::fail);
  EXPECT_EQ(atMost("gl", "", std::numeric_limits<double>::infinity(), 1.0, "").verdict, Verdict::fail);
  EXPECT_EQ(atMost("gl", "", 1.0, 1.0, "").verdict, Verdict::pass);
}

TEST(HardCaseList, numbersAreUnique) {
  std::set<std::string> ids;
  for (const HardCase& one : hardCases())
    EXPECT_TRUE(ids.insert(one.id).second) << one.id;
}

} // namespace
} // namespace limn
