// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"
#include "scene/volume/Histogram.h"

#include <QStringList>

#include <vector>

namespace limn {

/// A histogram like a CT head's: peaks of air (-1000 HU), fat (-100), soft tissue (40) and bone (700).
Histogram sampleHistogram();

/// Skin, muscle and bone over five points at -200, -60, 60, 300 and 1200 HU with opacities 0, 0.05, 0.2, 0.4,
/// 0.9.
TransferFunction sampleFunction();

/// A few presets of two modalities.
std::vector<Preset> samplePresets();

/// Every icon of the program's own set but those of one fixed colour, which belong to the style sheet.
QStringList iconNames();

} // namespace limn
