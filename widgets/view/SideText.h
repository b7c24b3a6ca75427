// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/view/PictureState.h"

#include <QString>

namespace limn {

/// The name of a shading model as the window shows it, translated.
QString modelName(ShadingModel model);

/// The few numbers that matter for how a side is lit: "SP 32" or "SP 1–64 · O 0–3", followed by contrast,
/// overflow of the highlights and drawing time where they are known. Projections that are not lit are named
/// instead.
QString sideDetails(const Scene& scene, const SideState& state);

} // namespace limn
