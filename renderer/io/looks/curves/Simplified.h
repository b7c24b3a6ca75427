// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"

#include <vector>

namespace limn {

/// Some of the points, first and last among them, such that the function through them stays within
/// `tolerance` (> 0) of every point in colour and opacity; steps stay where they are. `points` ascend in
/// value. A greedy walk that takes each piece as long as it gets.
std::vector<ControlPoint> simplified(const std::vector<ControlPoint>& points, double tolerance);

} // namespace limn
