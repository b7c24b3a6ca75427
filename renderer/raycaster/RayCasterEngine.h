// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"

namespace limn {

/// The ray caster on the current OpenGL context. Volumes for which the driver has no room are not drawn with
/// fewer voxels: they throw VolumeTooLarge. Throws Error (openGl) where the driver lacks what drawing needs.
std::unique_ptr<DrawingEngine> makeRayCasterEngine();

/// The same with volumes that take at most `mostVolumeMb` (10⁶ bytes) on the graphics card.
std::unique_ptr<DrawingEngine> makeRayCasterEngineWithin(double mostVolumeMb);

} // namespace limn
