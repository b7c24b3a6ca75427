// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"

#include <string>

namespace limn {

/// The report as a table for the terminal.
std::string accuracyTable(const AccuracyReport& report);

} // namespace limn
