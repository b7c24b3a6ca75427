// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/Bench.h"

#include <string>
#include <vector>

namespace limn {

/// Rows as one JSON object, keys as the command line documents them. `machine` names processor and renderer.
std::string benchJson(const std::string& machine, const std::vector<BenchRow>& rows);

/// Rows as a table for the terminal; where VTK's GPU mapper drew the same scene at the same step, what share
/// of its time each took.
std::string benchTable(const std::string& machine, const std::vector<BenchRow>& rows);

} // namespace limn
