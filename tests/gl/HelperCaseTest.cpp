// SPDX-License-Identifier: GPL-3.0-or-later
// Every case of kind `helper` of analytic_cases.json, in C++ and in GLSL. The table says who checks which
// cases; the ledger knows which were really compared.
#include "gl/HelperCases.h"
#include "support/AnalyticCases.h"
#include "support/GlTest.h"

namespace limn {
namespace {

struct HelperRow {
  const char* prefix; ///< of the id
  test::HelperCheck check;
};

const HelperRow helperRows[] = {
    {"D2_", test::checkEqualLayers},
    {"F1_", test::checkMaps},
    {"F3_", test::checkBlinnTerm},
    {"F7_", test::checkEnergyFactor},
    {"F8_", test::checkKnee},
    {"F9_", test::checkCurves},
    {"G1_", test::checkDifferences},
    {"G2_", test::checkAnisotropicNormal},
    {"G3_", test::checkBoundaryGradient},
    {"K1_", test::checkFunctionCoordinate},
    {"H1_", test::checkSegment},
    {"H2_", test::checkEqualEndpoints},
    {"L1_", test::checkMarschnerLobb},
};

using HelperCases = test::GlTest;

TEST_F(HelperCases, everyHelperCaseHoldsOnBothSides) {
  const nlohmann::json cases = test::analyticCases();
  test::CaseLedger ledger;
  for (const nlohmann::json& one : cases)
    for (const HelperRow& row : helperRows)
      if (test::isOfKind(one, "helper") && one["id"].get<std::string>().rfind(row.prefix, 0) == 0)
        row.check(one, ledger);
  ledger.expectEvery(cases, [](const nlohmann::json& one) { return test::isOfKind(one, "helper"); });
  ledger.print();
}

} // namespace
} // namespace limn
