// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/edits/CurvePlot.h"

#include "widgets/ValueText.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace limn {

ValueRange fullRange(const CurvePlot& plot) {
  ValueRange full = plot.values.value_or(ValueRange{1e300, -1e300});
  for (const ControlPoint& point : plot.function.points) {
    full.lowest = std::min(full.lowest, point.value);
    full.highest = std::max(full.highest, point.value);
  }
  if (full.lowest > full.highest)
    return {0.0, 1.0};
  const double width = full.highest - full.lowest;
  // A constant volume still needs an axis.
  const double margin = width > 0.0 ? 0.03 * width : std::max(1.0, std::abs(full.lowest) * 0.1);
  return {full.lowest - margin, full.highest + margin};
}

double valueUnit(const CurvePlot& plot) {
  if (plot.unit == QLatin1String("HU"))
    return 1.0;
  const ValueRange full = fullRange(plot);
  return std::pow(10.0, std::floor(std::log10((full.highest - full.lowest) / 500.0)));
}

CurveChange withPointAt(const CurvePlot& plot, double value, double opacity, int decimals) {
  const double place = std::max(value, lowestPlace(plot.subject));
  std::size_t index = 0;
  TransferFunction function = withPointAdded(plot.function, place, opacity, &index);
  return {std::move(function),
          {index},
          QObject::tr("add point at %1").arg(valueText(place, plot.unit, decimals))};
}

CurveChange withoutSelected(const CurvePlot& plot, int decimals) {
  const TransferFunction remaining = withPointsDeleted(plot.function, plot.selected);
  if (remaining == plot.function)
    return {plot.function, plot.selected, {}};
  const std::size_t first = plot.selected.front();
  const QString text = plot.selected.size() > 1
                           ? QObject::tr("delete %1 points").arg(plot.selected.size())
                           : QObject::tr("delete point at %1")
                                 .arg(valueText(plot.function.points[first].value, plot.unit, decimals));
  return {remaining, {std::min(first, remaining.points.size() - 1)}, text};
}

CurveChange nudged(const CurvePlot& plot, double units, double hundredths, int decimals) {
  const TransferFunction moved =
      limitedTo(plot.subject,
                withPointsMoved(plot.function, plot.selected, units * valueUnit(plot), hundredths * 0.01));
  const double value = moved.points[plot.selected.front()].value;
  return {moved, plot.selected, movedText(plot.selected.size(), valueText(value, plot.unit, decimals))};
}

QString movedText(std::size_t count, const QString& value) {
  return count > 1 ? QObject::tr("move %1 points").arg(count) : QObject::tr("move point to %1").arg(value);
}

} // namespace limn
