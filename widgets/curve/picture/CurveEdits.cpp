// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/picture/CurveEdits.h"

#include "widgets/ValueText.h"

#include <QObject>

#include <cmath>
#include <numeric>

namespace limn {
namespace {

// Removes points, but never the last one left: of all points the first stays.
TransferFunction withPointsDeleted(const TransferFunction& function, const PointIndices& indices) {
  PointIndices deleted = indices;
  if (deleted.size() >= function.points.size() && !deleted.empty())
    deleted.erase(deleted.begin());
  return withoutPoints(function, deleted);
}

} // namespace

PointIndices allPoints(const TransferFunction& function) {
  PointIndices all(function.points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

bool contains(const PointIndices& indices, std::size_t index) {
  return std::find(indices.begin(), indices.end(), index) != indices.end();
}

PointIndices withIndex(const PointIndices& indices, std::size_t index) {
  PointIndices more = withoutIndex(indices, index);
  more.insert(std::upper_bound(more.begin(), more.end(), index), index);
  return more;
}

PointIndices withoutIndex(const PointIndices& indices, std::size_t index) {
  PointIndices fewer = indices;
  std::erase(fewer, index);
  return fewer;
}

std::optional<std::size_t> pointAfter(const PointIndices& selected, std::size_t count, bool next) {
  if (count == 0)
    return std::nullopt;
  if (selected.empty())
    return next ? 0 : count - 1;
  if (next)
    return selected.back() + 1 < count ? std::optional(selected.back() + 1) : std::nullopt;
  return selected.front() > 0 ? std::optional(selected.front() - 1) : std::nullopt;
}

TransferFunction withPointsMoved(const TransferFunction& function, const PointIndices& indices,
                                 double valueOffset, double opacityOffset) {
  const auto& points = function.points;
  // Shorten the offset at every moved point whose neighbour stays.
  for (const std::size_t i : indices) {
    if (i > 0 && !contains(indices, i - 1))
      valueOffset = std::max(valueOffset, points[i - 1].value - points[i].value);
    if (i + 1 < points.size() && !contains(indices, i + 1))
      valueOffset = std::min(valueOffset, points[i + 1].value - points[i].value);
  }
  TransferFunction edited = function;
  for (const std::size_t i : indices) {
    edited.points[i].value += valueOffset;
    edited.points[i].opacity = std::clamp(points[i].opacity + opacityOffset, 0.0, 1.0);
  }
  // Adding the offset may round past a neighbour by the last bit.
  for (std::size_t i = 1; i < edited.points.size(); ++i)
    edited.points[i].value = std::max(edited.points[i].value, edited.points[i - 1].value);
  return edited;
}

double middleValue(const TransferFunction& function) {
  if (function.points.empty())
    return 0.0;
  return 0.5 * (function.points.front().value + function.points.back().value);
}

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

ValueRange reachOf(const CurvePlot& plot, std::size_t index) {
  const auto& points = plot.function.points;
  const ValueRange full = fullRange(plot);
  return {index > 0 ? points[index - 1].value : std::max(full.lowest, lowestPlace(plot.subject)),
          index + 1 < points.size() ? points[index + 1].value : full.highest};
}

CurveChange withPointAt(const CurvePlot& plot, double value, double opacity, int decimals) {
  const double place = std::max(value, lowestPlace(plot.subject));
  std::size_t index = 0;
  TransferFunction function = withPointAdded(plot.function, place, opacity, &index);
  return {std::move(function),
          {index},
          QObject::tr("add point at %1").arg(valueText(place, plot.unit, decimals))};
}

CurveChange withPointBeside(const CurvePlot& plot, const ValueRange& visible, int decimals) {
  const auto& points = plot.function.points;
  double value = std::midpoint(visible.lowest, visible.highest);
  if (!plot.selected.empty() && points.size() > 1) {
    const std::size_t from = std::min(plot.selected.back(), points.size() - 2);
    value = std::midpoint(points[from].value, points[from + 1].value);
  }
  return withPointAt(plot, value, classify(plot.function, value).opacity, decimals);
}

CurveChange withPointPlaced(const CurvePlot& plot, std::size_t index, double value, double opacity,
                            int decimals) {
  const ValueRange reach = reachOf(plot, index);
  TransferFunction moved =
      withPointMoved(plot.function, index, std::clamp(value, reach.lowest, reach.highest), opacity);
  const QString text = movedText(1, valueText(moved.points[index].value, plot.unit, decimals));
  return {std::move(moved), {index}, text};
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
