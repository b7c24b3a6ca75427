// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plot/PlotTransform.h"

#include <QColor>
#include <QString>

class QPainter;

namespace limn {

/// A labelled place on an axis.
struct AxisTick {
  double value = 0.0;
  QString text; ///< in the user's locale
};

/// Ticks at 1, 2 or 5 times a power of ten inside `range` (lowest < highest), at most `most` > 1 of them
/// where that is possible, with the decimals that tell them apart.
std::vector<AxisTick> linearTicks(const ValueRange& range, int most);

/// Ticks at 1, 2 and 5 times every power of ten inside `range` (0 < lowest < highest), or at powers of ten
/// alone, at most `most` ≥ 2.
std::vector<AxisTick> logarithmicTicks(const ValueRange& range, int most);

/// What a logarithmic axis shows that holds `lowest`..`highest` (0 < lowest ≤ highest) with some room at both
/// ends.
ValueRange logarithmicRange(double lowest, double highest);

/// How axes look.
struct AxisColors {
  QColor grid;
  QColor numbers;
  QColor title;
};

/// A line through every one of `lanes` at each tick, its number in the row of pixels `top`..`top` + `height`
/// and `title` at the right end of that row. A number that would touch the title is left out with its line.
void paintAxisAcross(QPainter& painter, const PlotTransform& transform, const std::vector<AxisTick>& ticks,
                     const QString& title, const std::vector<QRectF>& lanes, double top, double height,
                     const AxisColors& colors);

/// A line across the plot at each tick and its number `gap` pixels left of it, but where it would touch the
/// number below; `title` runs upwards around `titleX`, cut where that leaves the plot far.
void paintAxisUp(QPainter& painter, const PlotTransform& transform, const std::vector<AxisTick>& ticks,
                 const QString& title, double titleX, double gap, const AxisColors& colors);

} // namespace limn
