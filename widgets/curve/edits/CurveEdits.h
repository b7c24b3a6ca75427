// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace limn {

/// Indices of points, ascending.
using PointIndices = std::vector<std::size_t>;

PointIndices allPoints(const TransferFunction& function);

bool contains(const PointIndices& indices, std::size_t index);

/// With an index more, or unchanged where it is among them; and without it.
PointIndices withIndex(const PointIndices& indices, std::size_t index);
PointIndices withoutIndex(const PointIndices& indices, std::size_t index);

/// The point that Tab (or, not `next`, Shift+Tab) takes in hand after the `selected` of `count`; none where
/// the focus goes on, so that nobody is caught.
std::optional<std::size_t> pointAfter(const PointIndices& selected, std::size_t count, bool next);

/// Moves several points together. The value offset is shortened where a moved point would pass one that
/// stays; opacities stop at 0 and 1 one by one.
TransferFunction withPointsMoved(const TransferFunction& function, const PointIndices& indices,
                                 double valueOffset, double opacityOffset);

/// Removes points, but never the last one left: of all points the first stays.
TransferFunction withPointsDeleted(const TransferFunction& function, const PointIndices& indices);

/// The middle of the function's extent along the values; 0 without points.
double middleValue(const TransferFunction& function);

} // namespace limn
