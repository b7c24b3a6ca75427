// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/view/PictureState.h"

#include <QString>

namespace limn {

/// The name of a shading model as the window shows it, translated.
QString modelName(ShadingModel model);

/// The few numbers that matter for a side: contrast, overflow of the highlights and drawing time where they
/// are known, then how it is lit: "SP 32" or "SP 1–64 · O 0–3". Projections that are not lit are named
/// instead.
QString sideDetails(const Scene& scene, const SideState& state);

} // namespace limn
