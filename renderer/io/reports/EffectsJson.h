// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/EffectRows.h"

#include <string>
#include <vector>

namespace limn {

/// The effects of a scene as one JSON object, keys as the command line documents them. `costsMs` has one
/// entry per row, 0 where an effect costs nothing.
std::string effectsJson(const std::string& renderer, const std::vector<EffectRow>& rows,
                        const std::vector<double>& costsMs);

} // namespace limn
