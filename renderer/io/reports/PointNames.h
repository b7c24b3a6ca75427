// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/OperatingPoint.h"
#include "io/json/JsonFields.h"

namespace limn {

// What reports call renderers and sources of gradients.

inline constexpr Words<PointRenderer, 3> pointRendererNames{{"gl", "slices", "reference"}};
inline constexpr Words<GradientSource, 2> gradientSourceNames{{"on_the_fly", "precomputed"}};

} // namespace limn
