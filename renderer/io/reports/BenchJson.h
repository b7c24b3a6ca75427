// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/BenchRow.h"

namespace limn {

/// Rows as one JSON object, keys as the command line documents them. `machine` names processor and renderer.
std::string benchJson(const std::string& machine, const std::vector<BenchRow>& rows);

} // namespace limn
