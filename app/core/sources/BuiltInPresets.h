// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"

#include <vector>

namespace limn {

/// The presets made for this program, in the order in which they are listed.
std::vector<Preset> builtInPresets();

} // namespace limn
