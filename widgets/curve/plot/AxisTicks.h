// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <vector>

namespace limn {

/// Labelled places on an axis.
struct AxisTicks {
  double step = 1.0; ///< 1, 2 or 5 times a power of ten
  std::vector<double> values;
};

/// Round values inside `range` (lowest < highest), at most `most` > 1 of them where that is possible.
AxisTicks niceTicks(const ValueRange& range, int most);

} // namespace limn
