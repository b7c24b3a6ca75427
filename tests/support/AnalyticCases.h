// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/Places.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace limn::test {

/// The array of cases of analytic_cases.json, which lies beside this file.
inline nlohmann::json analyticCases() {
  std::ifstream stream(sourceFolder() / "tests/support/analytic_cases.json");
  return nlohmann::json::parse(stream)["cases"];
}

/// Whether a case is a `render`, a `helper` or a `fact`.
inline bool isOfKind(const nlohmann::json& one, const char* kind) {
  return one["kind"].get_ref<const std::string&>() == kind;
}

} // namespace limn::test
