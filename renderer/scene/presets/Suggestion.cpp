// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/Suggestion.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

namespace limn {
namespace {

// A band reaches so far to either side, in parts of the way from the boundary's low to its high value: far
// enough for samples half a voxel apart to meet it, and clear of both materials.
constexpr double halfWidth = 0.25;

// What is less prominent than this part of the most prominent boundary is not worth a row.
constexpr double leastProminence = 0.03;

constexpr double lowestOpacity = 0.15, highestOpacity = 0.9;

// From skin to bone, as clinicians are used to see them, and apart for eyes that tell red from green badly:
// lightness rises with the value.
constexpr std::array<glm::dvec3, 4> colors{glm::dvec3{0.73, 0.42, 0.32}, glm::dvec3{0.85, 0.55, 0.36},
                                           glm::dvec3{0.93, 0.77, 0.55}, glm::dvec3{0.98, 0.95, 0.88}};

glm::dvec3 colorAt(double share) {
  const double place = share * static_cast<double>(colors.size() - 1);
  const auto before = std::min(static_cast<std::size_t>(place), colors.size() - 2);
  return glm::mix(colors[before], colors[before + 1], place - static_cast<double>(before));
}

double prominenceOf(const Boundary& boundary) {
  return boundary.share * (boundary.high - boundary.low);
}

} // namespace

std::vector<Suggestion> suggestionsFor(const std::vector<Boundary>& boundaries, const ValueRange& range) {
  double most = 0.0;
  for (const Boundary& boundary : boundaries)
    most = std::max(most, prominenceOf(boundary));
  std::vector<Boundary> ascending;
  std::ranges::copy_if(boundaries, std::back_inserter(ascending), [&](const Boundary& boundary) {
    return prominenceOf(boundary) >= leastProminence * most;
  });
  std::ranges::stable_sort(ascending, {}, &Boundary::value);
  std::vector<Suggestion> suggestions;
  const auto last = static_cast<double>(ascending.size()) - 1.0;
  for (const Boundary& boundary : ascending) {
    const bool isHighest = suggestions.size() + 1 == ascending.size();
    const double place = isHighest ? 1.0 : static_cast<double>(suggestions.size()) / last;
    const double reach = halfWidth * (boundary.high - boundary.low);
    const glm::dvec3 color = colorAt(place);
    const double opacity = glm::mix(lowestOpacity, highestOpacity, place);
    const double end = boundary.value() + reach;
    suggestions.push_back(
        {boundary,
         {boundary.value() - reach, color, 0.0},
         {boundary.value(), color, opacity},
         {isHighest ? std::max(range.highest, end) : end, color, isHighest ? opacity : 0.0}});
  }
  std::ranges::stable_sort(suggestions, std::greater(),
                           [](const Suggestion& suggestion) { return prominenceOf(suggestion.boundary); });
  return suggestions;
}

TransferFunction withBand(const TransferFunction& function, const Suggestion& suggestion) {
  const TransferFunction band{function.unitDistanceMm, {suggestion.from, suggestion.top, suggestion.to}};
  const auto isWithin = [&](double value) {
    return value >= suggestion.from.value && value <= suggestion.to.value;
  };
  // Positive where the band is the more opaque.
  const auto lead = [&](double value) {
    return isWithin(value) ? classify(band, value).opacity - classify(function, value).opacity : -1.0;
  };
  const auto pointOf = [](const TransferFunction& of, double value) {
    const Classified at = classify(of, value);
    return ControlPoint{value, at.color, at.opacity};
  };

  // What of the function is not below the band, and what of the band is above the function.
  std::vector<ControlPoint> points;
  std::ranges::copy_if(function.points, std::back_inserter(points), [&](const ControlPoint& point) {
    return !isWithin(point.value) || point.opacity >= classify(band, point.value).opacity;
  });
  const auto isPoint = [&](double value) {
    return std::ranges::find(function.points, value, &ControlPoint::value) != function.points.end();
  };
  for (const ControlPoint& point : band.points)
    if (lead(point.value) > 0.0 ||
        (point.opacity == 0.0 && lead(point.value) == 0.0 && !isPoint(point.value)))
      points.push_back(point);

  // Where one line crosses the other the colours change, too.
  std::vector<double> values;
  for (const ControlPoint& point : function.points)
    if (isWithin(point.value))
      values.push_back(point.value);
  for (const ControlPoint& point : band.points)
    values.push_back(point.value);
  std::ranges::sort(values);
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    const double before = lead(values[i]);
    const double behind = lead(values[i + 1]);
    if (before * behind >= 0.0)
      continue;
    const double crossing = glm::mix(values[i], values[i + 1], before / (before - behind));
    const bool bandEnds = before > 0.0;
    points.push_back(pointOf(bandEnds ? band : function, crossing));
    points.push_back(pointOf(bandEnds ? function : band, crossing));
  }
  TransferFunction result = function;
  std::ranges::stable_sort(points, {}, &ControlPoint::value);
  result.points = std::move(points);
  return result;
}

} // namespace limn
