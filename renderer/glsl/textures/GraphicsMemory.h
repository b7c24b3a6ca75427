// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace limn {

/// No limit on what a volume may take on the graphics card but the driver's own.
inline constexpr double anyMb = std::numeric_limits<double>::infinity();

} // namespace limn
