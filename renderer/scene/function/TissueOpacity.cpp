// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/TissueOpacity.h"

#include <algorithm>

namespace limn {
namespace {

// Over the unit distance: below the first a tissue is hardly seen, from the second on it is.
constexpr double hardlySeen = 0.02, wellSeen = 0.05;

bool hasPointAt(const TransferFunction& function, double value) {
  return std::ranges::any_of(function.points,
                             [&](const ControlPoint& point) { return point.value == value; });
}

} // namespace

TransferFunction withOpacityChanged(const TransferFunction& function, const ValueBand& band,
                                    const std::function<double(double)>& change) {
  const double flank = (band.highest - band.lowest) / 2.0;
  const double before = band.lowest - flank;
  const double behind = band.highest + flank;
  TransferFunction result = function;
  for (const double value : {before, band.lowest, band.highest, behind})
    if (!hasPointAt(result, value))
      result = withPointAdded(result, value, classify(result, value).opacity);
  for (ControlPoint& point : result.points) {
    if (point.value < before || point.value > behind)
      continue;
    const double away = std::max({band.lowest - point.value, point.value - band.highest, 0.0});
    const double weight = flank > 0.0 ? 1.0 - away / flank : 1.0;
    point.opacity = std::clamp(glm::mix(point.opacity, change(point.opacity), weight), 0.0, 1.0);
  }
  return result;
}

double lessOpacity(double opacity) {
  return opacity < hardlySeen ? 0.0 : opacity / 2.0;
}

double moreOpacity(double opacity) {
  return std::min(1.0, std::max(2.0 * opacity, wellSeen));
}

} // namespace limn
