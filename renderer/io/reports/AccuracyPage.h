// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/AccuracySweep.h"

#include <string>

namespace limn {

/// A page that shows the chart in the file `chart` beside it, the points, and what each decision costs.
std::string accuracyPage(const AccuracyReport& report, const std::string& chart);

} // namespace limn
