// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/TransferFunction.h"

#include <cstddef>
#include <vector>

namespace limn {

/// Indices of points, ascending.
using PointIndices = std::vector<std::size_t>;

/// Moves several points together. The value offset is shortened where a moved point would pass one that
/// stays; opacities stop at 0 and 1 one by one.
TransferFunction withPointsMoved(const TransferFunction& function, const PointIndices& indices,
                                 double valueOffset, double opacityOffset);

/// Removes points, but never the last one left: of all points the first stays.
TransferFunction withPointsDeleted(const TransferFunction& function, const PointIndices& indices);

/// The middle of the function's extent along the values; 0 without points.
double middleValue(const TransferFunction& function);

} // namespace limn
