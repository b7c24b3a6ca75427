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

/// Whether no case and no seed failed.
bool holds(const StabilityReport& report);

/// A line that counts cases, rows, seeds and failures.
std::string stabilitySummary(const StabilityReport& report);

/// For the terminal: a line per case with the tightest row of each engine; rows that fail in full.
std::string stabilityTable(const StabilityReport& report);

/// One JSON object, keys as the command line documents them; figures that are no numbers are null.
std::string stabilityJson(const StabilityReport& report);

/// A page with every row and the pictures inside it, so that one file can be sent.
std::string stabilityPage(const StabilityReport& report);

} // namespace limn
