// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <optional>
#include <string>

namespace limn {

/// The scene without an effect, by the name of its row (scene/effects/EffectRows.h); absent where switching
/// it off alone means nothing: what light is made of, what was cut by hand.
std::optional<Scene> withoutEffect(Scene scene, const std::string& effect);

/// The scene with an effect as `before` has it.
Scene withEffect(Scene scene, const std::string& effect, const Scene& before);

} // namespace limn
