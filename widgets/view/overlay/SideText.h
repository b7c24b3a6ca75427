// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/Comparison.h"
#include "widgets/view/pictures/PictureState.h"

#include <QString>
#include <QStringList>

namespace limn {

/// What a side is called: its model, or the projection where that is not lit.
QString sideTitle(const Scene& scene);

/// What a side of a comparison is called: where looks are compared, which one, and its model.
QString sideTitle(const Comparison& comparison, int side);

/// The few numbers that matter for a side, the most important first: error, drawing time, contrast and
/// overflow of the highlights where they are known, then how it is lit: "SP 32" or "SP 1–64 · O 0–3". Of
/// projections that are not lit it says so.
QStringList sideDetails(const Scene& scene, const SideState& state);

} // namespace limn
