// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/StabilityReport.h"

#include <string>

namespace limn {

/// One JSON object, keys as the command line documents them; figures that are no numbers are null.
std::string stabilityJson(const StabilityReport& report);

} // namespace limn
