// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/pictures/StepSearch.h"

#include <optional>
#include <vector>

namespace limn {

/// How long it would take to bring pictures within half a level by halving their step again and again, ms:
/// `rough` estimates each at `stepVoxels`, all of them took `pictureMs`, and each halving takes twice as long
/// as what it halves. Infinite where the smallest step is not small enough, and where nothing is known.
double msOfHalvings(const std::vector<std::optional<ErrorEstimate>>& rough, double stepVoxels,
                    double pictureMs, double smallestStepVoxels);

/// Whether pictures are sooner within a tolerance with the error-controlled steps that were found for each
/// than after `halvingMs`. Never where one cannot be brought there, or together they would take longer than
/// `patienceMs`.
bool isToleranceShorter(const std::vector<NeededSteps>& needed, double halvingMs, double patienceMs);

} // namespace limn
