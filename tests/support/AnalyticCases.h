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

/// Whether a case is a `render`, a `helper` or a `fact`.
inline bool isOfKind(const nlohmann::json& one, const char* kind) {
  return one["kind"].get_ref<const std::string&>() == kind;
}

} // namespace limn::test
