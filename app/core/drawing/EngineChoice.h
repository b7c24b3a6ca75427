// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/Engine.h"
#include "scene/Scene.h"
#include "scene/basics/Message.h"

#include <functional>
#include <optional>
#include <string>

namespace limn {

/// What the same small pictures took with each engine, ms.
struct EngineTimes {
  double openGlMs = 0.0;
  double processorMs = 0.0;
  bool operator==(const EngineTimes&) const = default;
};

/// Where the outcome of trials is kept between runs, by machine.
struct EngineMemory {
  std::function<std::optional<EngineTimes>(const std::string& machine)> recall;
  std::function<void(const std::string& machine, const EngineTimes& times)> remember;
};

/// What decides which engine is the faster: a driver (by its name of what draws), and this processor with the
/// instructions that the CPU engine uses. Throws Error (usage) as makeCpuEngine does.
std::string machineWith(const std::string& renderer);

/// What there is to choose from.
struct EngineFacts {
  std::optional<Engine> setting;    ///< as chosen by the user
  Message problem;                  ///< why there is no OpenGL, a sentence; empty where there is
  std::string renderer;             ///< the driver's name of what draws
  std::optional<EngineTimes> times; ///< of a trial, if there was one
};

/// Which engine draws, and why.
struct EngineChoice {
  Engine engine = Engine::rayCaster;
  bool isGuess = false; ///< a trial may decide otherwise
  Message reason;       ///< one sentence
};

/// The engine that draws: the one asked for where there is OpenGL, the faster where none is asked for, and
/// until that is known the one that is likely to be.
EngineChoice chosenEngine(const EngineFacts& facts);

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
