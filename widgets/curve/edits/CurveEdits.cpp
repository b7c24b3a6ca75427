// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/edits/CurveEdits.h"

#include <algorithm>
#include <numeric>

namespace limn {

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

TransferFunction withPointsDeleted(const TransferFunction& function, const PointIndices& indices) {
  PointIndices deleted = indices;
  if (deleted.size() >= function.points.size() && !deleted.empty())
    deleted.erase(deleted.begin());
  return withoutPoints(function, deleted);
}

double middleValue(const TransferFunction& function) {
  if (function.points.empty())
    return 0.0;
  return 0.5 * (function.points.front().value + function.points.back().value);
}

} // namespace limn
