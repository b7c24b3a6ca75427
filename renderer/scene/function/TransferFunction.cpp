// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/TransferFunction.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limn {
namespace {

bool isFinite(const ControlPoint& point) {
  return std::isfinite(point.value) && std::isfinite(point.opacity) && std::isfinite(point.color.r) &&
         std::isfinite(point.color.g) && std::isfinite(point.color.b);
}

// The first point whose value is greater: of several at one value, the last is before it.
std::vector<ControlPoint>::const_iterator firstAbove(const TransferFunction& function, double value) {
  return std::upper_bound(function.points.begin(), function.points.end(), value,
                          [](double v, const ControlPoint& point) { return v < point.value; });
}

} // namespace

Classified classify(const TransferFunction& function, double value) {
  const auto& points = function.points;
  if (points.empty())
    return {};
  const auto right = firstAbove(function, value);
  if (right == points.begin())
    return {right->color, right->opacity};
  const auto left = right - 1;
  if (right == points.end())
    return {left->color, left->opacity};
  const double w = (value - left->value) / (right->value - left->value);
  return {glm::mix(left->color, right->color, w), glm::mix(left->opacity, right->opacity, w)};
}

double largestOpacityWithin(const TransferFunction& function, double low, double high) {
  double largest = std::max(classify(function, low).opacity, classify(function, high).opacity);
  for (const ControlPoint& point : function.points)
    if (point.value >= low && point.value <= high)
      largest = std::max(largest, point.opacity);
  return largest;
}

double extinctionPerMm(double opacity, double unitDistanceMm) {
  const double largest = 1.0 - std::ldexp(1.0, -24);
  return -std::log1p(-std::clamp(opacity, 0.0, largest)) / unitDistanceMm;
}

TransferFunction normalised(TransferFunction function) {
  if (!(function.unitDistanceMm > 0.0) || !std::isfinite(function.unitDistanceMm))
    throw Error(
        Error::Kind::input,
        Message::tr("The transfer function's unit distance must be a positive number of millimetres."));
  for (ControlPoint& point : function.points) {
    if (!isFinite(point))
      throw Error(Error::Kind::input,
                  Message::tr("A control point of the transfer function holds a number that is not finite."));
    point.color = glm::clamp(point.color, 0.0, 1.0);
    point.opacity = std::clamp(point.opacity, 0.0, 1.0);
  }
  std::stable_sort(function.points.begin(), function.points.end(),
                   [](const ControlPoint& a, const ControlPoint& b) { return a.value < b.value; });
  return function;
}

TransferFunction withPointAdded(const TransferFunction& function, double value, double opacity,
                                std::size_t* index) {
  const glm::dvec3 color = function.points.empty() ? glm::dvec3(1.0) : classify(function, value).color;
  TransferFunction edited = function;
  const auto place = firstAbove(function, value) - function.points.begin();
  edited.points.insert(edited.points.begin() + place, {value, color, std::clamp(opacity, 0.0, 1.0)});
  if (index)
    *index = static_cast<std::size_t>(place);
  return edited;
}

TransferFunction withPointMoved(const TransferFunction& function, std::size_t index, double value,
                                double opacity) {
  assert(index < function.points.size());
  TransferFunction edited = function;
  ControlPoint& point = edited.points[index];
  if (index > 0)
    value = std::max(value, function.points[index - 1].value);
  if (index + 1 < function.points.size())
    value = std::min(value, function.points[index + 1].value);
  point.value = value;
  point.opacity = std::clamp(opacity, 0.0, 1.0);
  return edited;
}

TransferFunction withoutPoints(const TransferFunction& function, const std::vector<std::size_t>& indices) {
  TransferFunction edited = function;
  edited.points.clear();
  for (std::size_t i = 0; i < function.points.size(); ++i)
    if (std::find(indices.begin(), indices.end(), i) == indices.end())
      edited.points.push_back(function.points[i]);
  return edited;
}

TransferFunction withPointColored(const TransferFunction& function, std::size_t index,
                                  const glm::dvec3& color) {
  assert(index < function.points.size());
  TransferFunction edited = function;
  edited.points[index].color = glm::clamp(color, 0.0, 1.0);
  return edited;
}

TransferFunction shifted(const TransferFunction& function, double offset) {
  TransferFunction edited = function;
  for (ControlPoint& point : edited.points)
    point.value += offset;
  return edited;
}

TransferFunction stretched(const TransferFunction& function, double centre, double factor) {
  assert(factor > 0.0);
  TransferFunction edited = function;
  for (ControlPoint& point : edited.points)
    point.value = centre + (point.value - centre) * factor;
  return edited;
}

TransferFunction withOpacityScaled(const TransferFunction& function, double factor) {
  TransferFunction edited = function;
  for (ControlPoint& point : edited.points)
    point.opacity = std::clamp(point.opacity * factor, 0.0, 1.0);
  return edited;
}

} // namespace limn
