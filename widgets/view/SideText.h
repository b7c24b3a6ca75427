// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <QString>

#include <optional>

namespace limn {

/// The name of a shading model as the window shows it, translated.
QString modelName(ShadingModel model);

/// What a side is called: its model, or the projection where that is not lit.
QString sideTitle(const Scene& scene);

/// The few numbers that matter for how a side is lit: "SP 32" or "SP 1–64 · O 0–3", followed by the drawing
/// time where it is known. Of projections that are not lit it says so.
QString sideDetails(const Scene& scene, std::optional<double> completeMs);

} // namespace limn
