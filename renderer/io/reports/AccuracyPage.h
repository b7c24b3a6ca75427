// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace limn {

struct AccuracyReport;

/// A page that shows the chart in the file `chart` beside it, the points, and what each decision costs.
std::string accuracyPage(const AccuracyReport& report, const std::string& chart);

} // namespace limn
