// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngines.h"

namespace limn {

/// What draws in the window: the ray caster, and where the driver fails the definition itself in double
/// precision on every core.
DrawingEngines viewEngines();

} // namespace limn
