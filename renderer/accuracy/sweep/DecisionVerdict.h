// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"

namespace limn {

/// Whether the costs measured justify how the program decides, a sentence each: one for every other way that
/// was as accurate at both steps (errors not above its own by more than the converged picture may be off:
/// 0.15 level at the 99.9th percentile, 0.005 in the mean, DEFINITION section 9) and took at most 0.9 of the
/// time; a single one where there is none. Nothing where nothing was measured.
std::vector<std::string> verdictOn(const std::vector<DecisionCost>& costs);

} // namespace limn
