// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/volume/Volume.h"

#include <vector>

namespace limn {

/// The function with the opacities of its points over another distance > 0, mm: what steps of that length
/// see.
TransferFunction overDistance(const TransferFunction& function, double mm);

/// The same where its unit distance is shorter than the smallest spacing, over that; otherwise the function.
/// A band that is faint over its unit distance may be opaque over a voxel.
TransferFunction overVoxelAtLeast(const TransferFunction& function, double smallestSpacingMm);

/// The largest change of a transfer function over a distance `width` along the value axis within `range`: of
/// opacity, or of a colour channel weighted by the opacity there; 0..1.
double largestChangeOver(const TransferFunction& function, double width, const ValueRange& range);

/// A peak or a valley of a transfer function's opacity, or of a colour channel weighted by it.
struct FunctionBand {
  ValueRange at;      ///< where it lies at half its height, one-sided plateaus included
  double width = 0.0; ///< of that, > 0
};

/// The peaks and valleys that are at least `height` deep on both sides, 0 < height ≤ 1. A peak of no width
/// is no band: no sample but by chance meets it, and no light comes from it.
std::vector<FunctionBand> bandsOf(const TransferFunction& function, double height);

/// The width, at half its height, of the narrowest peak or valley of the opacity within `range` that is at
/// least `height` deep on both sides; infinite without any.
double narrowestBand(const TransferFunction& function, double height, const ValueRange& range);

/// The same of everything that is seen: of the opacity, and of the colour channels weighted by it.
double narrowestVisibleBand(const TransferFunction& function, double height, const ValueRange& range);

} // namespace limn
