// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/presets/Boundaries.h"

#include <vector>

namespace limn {

/// A band of the transfer function that makes one boundary visible.
struct Suggestion {
  Boundary boundary;
  ControlPoint from; ///< where the band begins; its opacity is 0
  ControlPoint top;  ///< at the boundary's value
  ControlPoint to;   ///< where it ends, of the top's opacity where nothing lies above it, else 0
  bool operator==(const Suggestion&) const = default;
};

/// A band for each boundary of a volume that counts, the most prominent (large and of high contrast) first.
/// They are told apart by colour; the higher the value, the more opaque, so that what lies inside is seen
/// through what is around it. `range` is the volume's, in the boundaries' unit.
std::vector<Suggestion> suggestionsFor(const std::vector<Boundary>& boundaries, const ValueRange& range);

/// The function, or the band where that is more opaque: nothing that shows becomes more transparent.
TransferFunction withBand(const TransferFunction& function, const Suggestion& suggestion);

} // namespace limn
