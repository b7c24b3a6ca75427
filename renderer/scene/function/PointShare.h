// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"

namespace limn {

/// What shows values that a point governs: no tissue is green.
inline constexpr glm::dvec3 emphasisColor{0.2, 0.95, 0.4};

/// How much a control point has of a value's colour and opacity, 0..1: all at its own value, falling evenly
/// to nothing at its neighbours'; outside the first and the last point all is theirs. Of points at one value
/// the last has all of it. `point` is one of the function's.
double shareOfPoint(const TransferFunction& function, std::size_t point, double value);

/// The function with what a point governs in the colour of emphasis, by its share, and everything else grey
/// and so faint that it hides nothing. What a faint point governs is drawn well seen; what a transparent one
/// governs stays so.
TransferFunction withPointEmphasised(const TransferFunction& function, std::size_t point);

} // namespace limn
