// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/effects/EffectPlan.h"

namespace limn {

/// Throws Error (usage) naming what slices cannot draw: every projection but composite and X-ray, which is
/// white blended alike. Blending knows one operation, and no slice knows those before it.
void requireSliceable(const Scene& scene);

/// The effects of a scene that a slice draws: what the scene calls for, less what belongs to the march along
/// a ray, with the reason.
EffectPlan sliceEffects(const Scene& scene, const SceneFacts& facts);

} // namespace limn
