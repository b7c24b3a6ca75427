// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/CaseLedger.h"

namespace limn::test {

/// Checks of the cases of kind `helper`, one per group: the C++ function and its GLSL twin
/// against the case's figures. They need a current context and count in the ledger what they compare.
using HelperCheck = void (*)(const nlohmann::json& one, CaseLedger& ledger);

void checkMaps(const nlohmann::json& one, CaseLedger& ledger);
void checkBlinnTerm(const nlohmann::json& one, CaseLedger& ledger);
void checkEnergyFactor(const nlohmann::json& one, CaseLedger& ledger);
void checkKnee(const nlohmann::json& one, CaseLedger& ledger);
void checkCurves(const nlohmann::json& one, CaseLedger& ledger);
void checkEqualLayers(const nlohmann::json& one, CaseLedger& ledger);
void checkFunctionCoordinate(const nlohmann::json& one, CaseLedger& ledger);
void checkDifferences(const nlohmann::json& one, CaseLedger& ledger);
void checkAnisotropicNormal(const nlohmann::json& one, CaseLedger& ledger);
void checkBoundaryGradient(const nlohmann::json& one, CaseLedger& ledger);
void checkSegment(const nlohmann::json& one, CaseLedger& ledger);
void checkEqualEndpoints(const nlohmann::json& one, CaseLedger& ledger);
void checkMarschnerLobb(const nlohmann::json& one, CaseLedger& ledger);

/// The figure of a key of the case, whether written as a number or with its digits.
double expectedFigure(const nlohmann::json& entry);

/// Both sides against one figure, within the case's tolerances. Arguments are rounded to float on the way to
/// GLSL, so its tolerance is relative above 1.
void expectBoth(const nlohmann::json& one, CaseLedger& ledger, const std::string& what, double expected,
                double cpu, double gpu);

} // namespace limn::test
