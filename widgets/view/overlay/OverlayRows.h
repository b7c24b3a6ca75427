// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

#include <vector>

namespace limn {

/// Where texts of `size` that stand at one height on all sides of a view keep clear of the plates of the
/// overlay. `columns` are the horizontal centres of the texts; all in logical pixels, y down. Sides that are
/// compared must look alike, so where one text has to yield all do.

/// The upper edge of the texts: at `top`, or as little below it as the plates allow.
double clearRowBelow(double top, const QSizeF& size, const std::vector<double>& columns,
                     const std::vector<QRectF>& plates);

/// The lower edge of the texts: at `bottom`, or as little above it as the plates allow.
double clearRowAbove(double bottom, const QSizeF& size, const std::vector<double>& columns,
                     const std::vector<QRectF>& plates);

} // namespace limn
