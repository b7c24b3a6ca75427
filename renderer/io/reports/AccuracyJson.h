// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/AccuracySweep.h"

#include <string>

namespace limn {

/// The report as one JSON object, keys as the command line documents them; errors are null where the exact
/// picture did not converge.
std::string accuracyJson(const AccuracyReport& report);

/// One line per point, comma separated, with a header; errors are empty where there are none.
std::string accuracyCsv(const AccuracyReport& report);

} // namespace limn
