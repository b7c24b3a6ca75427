// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/drawing/EngineChoice.h"
#include "scene/Scene.h"

namespace limn {

/// What came out of trying both engines.
struct EngineTrial {
  std::string renderer; ///< the driver's name of what drew with OpenGL
  EngineTimes times;
};

/// Draws a scene in small pictures with both engines in turn and keeps the shortest time of each; what is
/// made once (textures, programs, tables) is not counted. Takes about a second on a processor, and makes an
/// OpenGL context of its own: no other may be current on the thread. `isCancelled`, which may be empty, is
/// asked between two pictures and within those of the processor; true ends it with Cancelled. Throws Error.
EngineTrial tryEngines(const Scene& scene, const std::function<bool()>& isCancelled);

} // namespace limn
