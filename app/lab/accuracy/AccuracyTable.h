// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/Cohort.h"

#include <string>

namespace limn {

/// The report as a table for the terminal.
std::string accuracyTable(const AccuracyReport& report);

/// The groups of a cohort as tables: a line for each point, with what it usually brings and what it brought
/// in the worst scene.
std::string cohortTable(const std::vector<CohortGroup>& groups);

} // namespace limn
