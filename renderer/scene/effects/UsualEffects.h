// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/effects/EffectRows.h"

#include <optional>

namespace limn {

/// The scene with an effect that its picture does without: with the scene's own numbers, and where they ask
/// for none with usual ones (those of the studio light for shadows and hollows). Absent where the row is on,
/// where switching it on alone means nothing or takes a copy of the volume (smooth normals), or where the
/// picture would not show it all the same, by the `facts` of the scene as it is.
std::optional<Scene> withUsualEffect(const Scene& scene, const EffectRow& row, const SceneFacts& facts);

} // namespace limn
