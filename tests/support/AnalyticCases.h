// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/TestData.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace limn::test {

inline const char* const analyticCasesFile = "analytic_cases.json";

/// The array of cases of the shared file; it must exist (LIMN_NEEDS_SHARED).
inline nlohmann::json analyticCases() {
  std::ifstream stream(sharedFolder() / analyticCasesFile);
  return nlohmann::json::parse(stream)["cases"];
}

} // namespace limn::test
