// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace limn {

/// Who draws (README.md). Where the program is to choose, an absent one stands for the faster of the ray
/// caster and the CPU engine.
enum class Engine {
  rayCaster,         ///< rays in GLSL
  slices,            ///< view-aligned slices in GLSL, blended front to back
  slicesBackToFront, ///< the same slices in the other order
  cpu,               ///< rays on the processor, in single precision
  reference          ///< the definition itself, in double precision
};

/// Every engine, in the order in which it is declared.
inline constexpr std::array allEngines{Engine::rayCaster, Engine::slices, Engine::slicesBackToFront,
                                       Engine::cpu, Engine::reference};

/// The word for an engine on the command line, in settings and in reports.
constexpr const char* nameOf(Engine engine) {
  constexpr std::array names{"gl", "slices", "slices-back-to-front", "cpu", "reference"};
  return names[static_cast<std::size_t>(engine)];
}

/// The same; "auto" where the program is to choose.
constexpr const char* nameOf(const std::optional<Engine>& engine) {
  return engine ? nameOf(*engine) : "auto";
}

/// The engine that a word stands for; absent for "auto" and for any other word.
constexpr std::optional<Engine> engineNamed(std::string_view word) {
  for (const Engine engine : allEngines)
    if (word == nameOf(engine))
      return engine;
  return std::nullopt;
}

/// Whether an engine needs a context of OpenGL: it draws into the framebuffer bound. The others draw in
/// memory.
constexpr bool drawsWithOpenGl(Engine engine) {
  return engine != Engine::cpu && engine != Engine::reference;
}

} // namespace limn
