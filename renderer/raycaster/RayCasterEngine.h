// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"

namespace limn {

/// The ray caster on the current OpenGL context. Throws Error (openGl) where the driver lacks what drawing
/// needs.
std::unique_ptr<DrawingEngine> makeRayCasterEngine();

} // namespace limn
