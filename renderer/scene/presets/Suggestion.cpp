// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/Suggestion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

// A band reaches so far to either side, in parts of the way from the boundary's low to its high value: far
// enough for samples half a voxel apart to meet it, and clear of both materials.
constexpr double halfWidth = 0.25;

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

} // namespace

std::vector<Suggestion> suggestionsFor(const std::vector<Boundary>& boundaries, const ValueRange& range) {
  std::vector<Boundary> ascending = boundaries;
  std::stable_sort(ascending.begin(), ascending.end(),
                   [](const Boundary& a, const Boundary& b) { return a.value() < b.value(); });
  std::vector<Suggestion> suggestions;
  const double last = std::max<double>(1.0, static_cast<double>(ascending.size()) - 1.0);
  for (const Boundary& boundary : ascending) {
    const bool isHighest = suggestions.size() + 1 == ascending.size();
    const double share = ascending.size() == 1 ? 1.0 : static_cast<double>(suggestions.size()) / last;
    const double reach = halfWidth * (boundary.high - boundary.low);
    const glm::dvec3 color = colorAt(share);
    const double opacity = glm::mix(lowestOpacity, highestOpacity, share);
    const double end =
        isHighest ? std::max(range.highest, boundary.value() + reach) : boundary.value() + reach;
    suggestions.push_back({boundary,
                           {boundary.value() - reach, color, 0.0},
                           {boundary.value(), color, opacity},
                           {end, color, isHighest ? opacity : 0.0}});
  }
  return suggestions;
}

TransferFunction withBand(const TransferFunction& function, const Suggestion& suggestion) {
  const auto isOutside = [&](const ControlPoint& point) {
    return point.value < suggestion.from.value || point.value > suggestion.to.value;
  };
  // Where the band begins and ends the function keeps what it had, in a step.
  const auto keptAt = [&](double value) {
    const Classified kept = classify(function, value);
    return ControlPoint{value, kept.color, kept.opacity};
  };
  TransferFunction result = function;
  std::erase_if(result.points, [&](const ControlPoint& point) { return !isOutside(point); });
  const auto behind =
      std::find_if(result.points.begin(), result.points.end(),
                   [&](const ControlPoint& point) { return point.value > suggestion.to.value; });
  std::vector<ControlPoint> band;
  if (const ControlPoint kept = keptAt(suggestion.from.value); kept.opacity > 0.0)
    band.push_back(kept);
  band.insert(band.end(), {suggestion.from, suggestion.top, suggestion.to});
  if (const ControlPoint kept = keptAt(suggestion.to.value);
      kept.opacity > 0.0 && behind != result.points.end())
    band.push_back(kept);
  result.points.insert(behind, band.begin(), band.end());
  return result;
}

} // namespace limn
