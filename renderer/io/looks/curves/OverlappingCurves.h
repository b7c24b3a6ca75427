// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"

#include <vector>

namespace limn {

/// The most curves of a look that may be joined.
inline constexpr std::size_t mostJoinedCurves = 64;

/// Several curves as one function: opacity is 0 outside each, and where some overlap, the most opaque one
/// shows, exactly. `overlap`, if given, receives whether any do. Each curve ascends in value and has points;
/// there are at most mostJoinedCurves.
TransferFunction joined(const std::vector<std::vector<ControlPoint>>& curves, bool* overlap = nullptr);

} // namespace limn
