// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/HardCase.h"
#include "stability/PictureFuzz.h"

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// What `limn stability` found, and on what: enough for somebody else to judge it, and nothing personal.
struct StabilityReport {
  std::string version;
  std::string renderer; ///< e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;   ///< its versions and limits
  std::string machine;  ///< processor and system
  std::string date;     ///< of measuring, ISO 8601
  std::string command;  ///< that measures the same again
  std::vector<MeasuredCase> cases;
  std::optional<FuzzReport> fuzz;
};

} // namespace limn
