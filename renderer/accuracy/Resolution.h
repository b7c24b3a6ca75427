// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

namespace limn {

/// A band of the transfer function counts where it rises or falls by at least this much opacity, or colour
/// weighted by it: the height below which `stepResolvesFunction` lets samples miss one.
inline constexpr double leastBandHeight = 0.1;

/// Whether steps of the scene's length can see the transfer function: no band of it that shows in the picture
/// is narrower than what the value commonly changes by in a step, `steepestPerMm` times its length. Where one
/// is, a picture and that of half the step may both step over it, and their difference says nothing.
/// Pre-integrated steps pass through every band, so they see it however narrow; so do projections that
/// classify no samples.
bool stepSeesFunction(const Scene& scene, double steepestPerMm, bool isPreintegrated);

} // namespace limn
