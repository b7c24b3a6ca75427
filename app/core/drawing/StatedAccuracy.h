// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/ErrorByChance.h"
#include "io/scenefile/SceneFile.h"

namespace limn {

/// What a picture's file keeps of pixels that were drawn at random and integrated exactly.
PictureAccuracy accuracyByChance(const ErrorByChance& error);

/// The same of an estimate, the 99.9th percentile in levels: it says that it is one.
PictureAccuracy accuracyByEstimate(double levels);

} // namespace limn
