// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/OperatingPoint.h"
#include "io/json/JsonFields.h"

namespace limn {

// The engines of points, in the order in which reports list them, and what they call sources of gradients.

inline constexpr std::array pointEngines{Engine::rayCaster, Engine::slices, Engine::reference};
inline constexpr Words<GradientSource, 2> gradientSourceNames{{"on_the_fly", "precomputed"}};

} // namespace limn
