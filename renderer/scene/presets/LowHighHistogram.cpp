// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/LowHighHistogram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace limn {
namespace {

constexpr int bins = 256; // along each axis

// Places beyond these quantiles widen no bin.
constexpr double outermost = 0.005;

// Bins are smoothed by three passes over this many on either side, close to a Gaussian.
constexpr int smoothing = 1;

// Of an axis both of whose ends, `low` and `high`, are values.
struct Axis {
  double lowest = 0.0;
  double width = 1.0; // of a bin

  int binOf(double value) const {
    return std::clamp(static_cast<int>(std::floor((value - lowest) / width)), 0, bins - 1);
  }
};

Axis axisOf(const std::vector<LowAndHigh>& places) {
  std::vector<double> values;
  values.reserve(2 * places.size());
  for (const LowAndHigh& place : places)
    values.insert(values.end(), {place.low, place.high});
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  const double lowest = values[static_cast<std::size_t>(outermost * last)];
  const double highest = values[static_cast<std::size_t>((1.0 - outermost) * last)];
  return {lowest, highest > lowest ? (highest - lowest) / (bins - 1) : 1.0};
}

// Counts over low and high.
using Counts = std::vector<double>;

std::size_t offsetOf(int low, int high) {
  return static_cast<std::size_t>(high) * bins + static_cast<std::size_t>(low);
}

// The mean of neighbours along an axis whose bins lie `stride` apart.
Counts averaged(const Counts& counts, bool alongLow) {
  Counts result(counts.size());
  for (int high = 0; high < bins; ++high)
    for (int low = 0; low < bins; ++low) {
      double sum = 0.0;
      for (int n = -smoothing; n <= smoothing; ++n) {
        const int l = alongLow ? low + n : low;
        const int h = alongLow ? high : high + n;
        if (l >= 0 && l < bins && h >= 0 && h < bins)
          sum += counts[offsetOf(l, h)];
      }
      result[offsetOf(low, high)] = sum / (2 * smoothing + 1);
    }
  return result;
}

// The bin that is reached by going up from one.
std::size_t peakAbove(const Counts& counts, std::size_t bin) {
  for (;;) {
    const int low = static_cast<int>(bin) % bins;
    const int high = static_cast<int>(bin) / bins;
    std::size_t best = bin;
    for (int h = std::max(0, high - 1); h <= std::min(bins - 1, high + 1); ++h)
      for (int l = std::max(0, low - 1); l <= std::min(bins - 1, low + 1); ++l)
        if (counts[offsetOf(l, h)] > counts[best])
          best = offsetOf(l, h);
    if (best == bin)
      return bin;
    bin = best;
  }
}

} // namespace

std::vector<LowHighPeak> peaksOf(std::vector<LowAndHigh> places) {
  if (places.empty())
    return {};
  // Sums of the same numbers in another order differ in their last bits.
  std::sort(places.begin(), places.end(), [](const LowAndHigh& a, const LowAndHigh& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  const Axis axis = axisOf(places);
  Counts counts(std::size_t{bins} * bins, 0.0);
  for (const LowAndHigh& place : places)
    ++counts[offsetOf(axis.binOf(place.low), axis.binOf(place.high))];
  for (int pass = 0; pass < 3; ++pass)
    counts = averaged(averaged(counts, true), false);

  // What belongs to each peak, and the mean of those close to its top: the flanks lean to other peaks.
  struct Sum {
    double members = 0.0, near = 0.0, low = 0.0, high = 0.0;
  };
  std::vector<Sum> sums(counts.size());
  std::vector<std::size_t> peakOf(counts.size(), counts.size());
  for (const LowAndHigh& place : places) {
    const int low = axis.binOf(place.low);
    const int high = axis.binOf(place.high);
    std::size_t& peak = peakOf[offsetOf(low, high)];
    if (peak == counts.size())
      peak = peakAbove(counts, offsetOf(low, high));
    Sum& sum = sums[peak];
    ++sum.members;
    if (std::abs(low - static_cast<int>(peak) % bins) > 1 ||
        std::abs(high - static_cast<int>(peak) / bins) > 1)
      continue;
    ++sum.near;
    sum.low += place.low;
    sum.high += place.high;
  }
  std::vector<LowHighPeak> peaks;
  for (const Sum& sum : sums)
    if (sum.near > 0.0)
      peaks.push_back(
          {{sum.low / sum.near, sum.high / sum.near}, sum.members / static_cast<double>(places.size())});
  std::stable_sort(peaks.begin(), peaks.end(),
                   [](const LowHighPeak& a, const LowHighPeak& b) { return a.share > b.share; });
  return peaks;
}

} // namespace limn
