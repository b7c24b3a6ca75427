// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/FunctionDetail.h"

#include "scene/basics/StableMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double changeBetween(const Classified& a, const Classified& b) {
  const glm::dvec3 color = glm::abs(b.color - a.color) * std::min(a.opacity, b.opacity);
  return std::max({std::abs(b.opacity - a.opacity), color.r, color.g, color.b});
}

// Opacities, or their negatives for valleys, over values.
struct DetailProfile {
  std::vector<double> values;
  std::vector<double> heights;
};

// What lies on one side of a point that rises above it: how far it falls before it rises higher again.
double fallBeside(const DetailProfile& profile, std::size_t peak, int side) {
  double lowest = profile.heights[peak];
  for (auto i = static_cast<std::ptrdiff_t>(peak) + side;
       i >= 0 && i < static_cast<std::ptrdiff_t>(profile.heights.size()); i += side) {
    const double height = profile.heights[static_cast<std::size_t>(i)];
    if (height > profile.heights[peak])
      break;
    lowest = std::min(lowest, height);
  }
  return profile.heights[peak] - lowest;
}

// How far from a point the profile first falls to a level.
double distanceTo(const DetailProfile& profile, std::size_t peak, double level, int side) {
  for (auto i = static_cast<std::ptrdiff_t>(peak) + side;
       i >= 0 && i < static_cast<std::ptrdiff_t>(profile.heights.size()); i += side) {
    const auto here = static_cast<std::size_t>(i);
    const auto before = static_cast<std::size_t>(i - side);
    if (profile.heights[here] > level)
      continue;
    const double w = (profile.heights[before] - level) / (profile.heights[before] - profile.heights[here]);
    const double at = profile.values[before] + w * (profile.values[here] - profile.values[before]);
    return std::abs(at - profile.values[peak]);
  }
  return infinite;
}

// Opacity, and each colour channel weighted by it.
double heightOf(const ControlPoint& point, int channel) {
  return channel < 3 ? point.color[channel] * point.opacity : point.opacity;
}

DetailProfile profileOf(const TransferFunction& function, int channel, double sign) {
  DetailProfile profile;
  for (const ControlPoint& point : function.points) {
    profile.values.push_back(point.value);
    profile.heights.push_back(sign * heightOf(point, channel));
  }
  return profile;
}

void addPeaks(const DetailProfile& profile, double height, std::vector<FunctionBand>& bands) {
  for (std::size_t i = 0; i < profile.values.size(); ++i) {
    const double fall = std::min(fallBeside(profile, i, -1), fallBeside(profile, i, 1));
    if (fall < height)
      continue;
    const double level = profile.heights[i] - 0.5 * fall;
    const double from = profile.values[i] - distanceTo(profile, i, level, -1);
    const double to = profile.values[i] + distanceTo(profile, i, level, 1);
    if (to > from)
      bands.push_back({{from, to}, to - from});
  }
}

double narrowestPeak(const DetailProfile& profile, double height, const ValueRange& range) {
  double narrowest = infinite;
  for (std::size_t i = 0; i < profile.values.size(); ++i) {
    if (profile.values[i] < range.lowest || profile.values[i] > range.highest)
      continue;
    const double fall = std::min(fallBeside(profile, i, -1), fallBeside(profile, i, 1));
    if (fall < height)
      continue;
    const double level = profile.heights[i] - 0.5 * fall;
    narrowest = std::min(narrowest, distanceTo(profile, i, level, -1) + distanceTo(profile, i, level, 1));
  }
  return narrowest;
}

// The narrowest peak or valley.
double narrowestOf(DetailProfile profile, double height, const ValueRange& range) {
  const double peak = narrowestPeak(profile, height, range);
  for (double& h : profile.heights)
    h = -h;
  return std::min(peak, narrowestPeak(profile, height, range));
}

DetailProfile profileOf(const TransferFunction& function, double (*heightOf)(const ControlPoint& point)) {
  DetailProfile profile;
  for (const ControlPoint& point : function.points) {
    profile.values.push_back(point.value);
    profile.heights.push_back(heightOf(point));
  }
  return profile;
}

} // namespace

TransferFunction overDistance(const TransferFunction& function, double mm) {
  TransferFunction other = function;
  other.unitDistanceMm = mm;
  for (ControlPoint& point : other.points)
    point.opacity = oneMinusExpNeg(extinctionPerMm(point.opacity, function.unitDistanceMm) * mm);
  return other;
}

TransferFunction overVoxelAtLeast(const TransferFunction& function, double smallestSpacingMm) {
  return function.unitDistanceMm < smallestSpacingMm ? overDistance(function, smallestSpacingMm) : function;
}

double largestChangeOver(const TransferFunction& function, double width, const ValueRange& range) {
  // A difference of piecewise linear functions is largest where one of the two has a knot.
  double largest = 0.0;
  for (const ControlPoint& point : function.points)
    for (const double from : {point.value - width, point.value}) {
      if (from + width < range.lowest || from > range.highest)
        continue;
      largest = std::max(largest, changeBetween(classify(function, from), classify(function, from + width)));
    }
  return largest;
}

std::vector<FunctionBand> bandsOf(const TransferFunction& function, double height) {
  std::vector<FunctionBand> bands;
  for (int channel = 0; channel < 4; ++channel)
    for (const double sign : {1.0, -1.0})
      addPeaks(profileOf(function, channel, sign), height, bands);
  return bands;
}

double narrowestBand(const TransferFunction& function, double height, const ValueRange& range) {
  const auto opacity = [](const ControlPoint& point) { return point.opacity; };
  return narrowestOf(profileOf(function, opacity), height, range);
}

double narrowestVisibleBand(const TransferFunction& function, double height, const ValueRange& range) {
  const auto red = [](const ControlPoint& point) { return point.opacity * point.color.r; };
  const auto green = [](const ControlPoint& point) { return point.opacity * point.color.g; };
  const auto blue = [](const ControlPoint& point) { return point.opacity * point.color.b; };
  double narrowest = narrowestBand(function, height, range);
  for (const DetailProfile& profile :
       {profileOf(function, red), profileOf(function, green), profileOf(function, blue)})
    narrowest = std::min(narrowest, narrowestOf(profile, height, range));
  return narrowest;
}

} // namespace limn
