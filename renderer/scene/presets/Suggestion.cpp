// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/Suggestion.h"

#include "scene/light/Gradient.h"
#include "scene/light/GradientHistogram.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <mutex>

namespace limn {
namespace {

constexpr int histogramBins = 256; // along each axis

// Places beyond these quantiles widen no bin.
constexpr double outermost = 0.005;

// Bins are smoothed by three passes over this many on either side, close to a Gaussian.
constexpr int smoothing = 1;

// Of an axis both of whose ends, `low` and `high`, are values.
struct Axis {
  double lowest = 0.0;
  double width = 1.0; // of a bin

  int binOf(double value) const {
    return std::clamp(static_cast<int>(std::floor((value - lowest) / width)), 0, histogramBins - 1);
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
  return {lowest, highest > lowest ? (highest - lowest) / (histogramBins - 1) : 1.0};
}

// Counts over low and high.
using Counts = std::vector<double>;

std::size_t offsetOf(int low, int high) {
  return static_cast<std::size_t>(high) * histogramBins + static_cast<std::size_t>(low);
}

// The mean of neighbours along an axis whose histogramBins lie `stride` apart.
Counts averaged(const Counts& counts, bool alongLow) {
  Counts result(counts.size());
  for (int high = 0; high < histogramBins; ++high)
    for (int low = 0; low < histogramBins; ++low) {
      double sum = 0.0;
      for (int n = -smoothing; n <= smoothing; ++n) {
        const int l = alongLow ? low + n : low;
        const int h = alongLow ? high : high + n;
        if (l >= 0 && l < histogramBins && h >= 0 && h < histogramBins)
          sum += counts[offsetOf(l, h)];
      }
      result[offsetOf(low, high)] = sum / (2 * smoothing + 1);
    }
  return result;
}

// The bin that is reached by going up from one.
std::size_t peakAbove(const Counts& counts, std::size_t bin) {
  for (;;) {
    const int low = static_cast<int>(bin) % histogramBins;
    const int high = static_cast<int>(bin) / histogramBins;
    std::size_t best = bin;
    for (int h = std::max(0, high - 1); h <= std::min(histogramBins - 1, high + 1); ++h)
      for (int l = std::max(0, low - 1); l <= std::min(histogramBins - 1, low + 1); ++l)
        if (counts[offsetOf(l, h)] > counts[best])
          best = offsetOf(l, h);
    if (best == bin)
      return bin;
    bin = best;
  }
}

// Weaker changes than this part of the strongest common ones are shades within a material.
constexpr double weakest = 0.02;
constexpr double strongestQuantile = 0.999;

// Most voxels lie within materials, where nothing changes but by noise. Of moduli of Gaussian noise one in
// ten thousand is three times their median.
constexpr double overNoise = 3.0;

// So many places tell as much as all.
constexpr std::uint64_t mostPlaces = 400000;

// The field is followed so far to either side, in steps of half a voxel along the axis of its steepest way.
constexpr int mostSteps = 12;

// It stops changing where a step gains no more than this part of the largest one.
constexpr double standstill = 0.1;

constexpr double leastShare = 0.01;

// Two boundaries of which so much is common are one: what is thin does not reach its value everywhere.
constexpr double sameOverlap = 0.7;

// A well-mixed hash of a voxel's number, so that places are spread evenly and always the same.
std::uint64_t scattered(std::uint64_t number) {
  number = (number ^ (number >> 31)) * 0x9e3779b97f4a7c15u;
  return number ^ (number >> 29);
}

// A volume's voxels between their centres, scalar units: `valueAt` without a look at the type for each.
template <class T>
class Field {
public:
  Field(const Volume& volume, const StoredVoxels<T>& stored)
      : m_rescale(volume.rescale()), m_stored(stored), m_dims(volume.grid().dims) {}

  double at(const glm::dvec3& index) const {
    const glm::dvec3 inside = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(m_dims - 1));
    const glm::ivec3 low = glm::min(glm::ivec3(inside), glm::max(m_dims - 2, 0));
    const glm::dvec3 w = inside - glm::dvec3(low);
    const glm::ivec3 high = glm::min(low + 1, m_dims - 1);
    const auto row = [&](int j, int k) { return glm::mix(voxel(low.x, j, k), voxel(high.x, j, k), w.x); };
    const double stored = glm::mix(glm::mix(row(low.y, low.z), row(high.y, low.z), w.y),
                                   glm::mix(row(low.y, high.z), row(high.y, high.z), w.y), w.z);
    return m_rescale.slope * stored + m_rescale.intercept;
  }

private:
  double voxel(int i, int j, int k) const {
    return static_cast<double>(m_stored[voxelOffset(m_dims, i, j, k)]);
  }

  Rescale m_rescale;
  const StoredVoxels<T>& m_stored;
  glm::ivec3 m_dims;
};

// The field along its gradient at a place, which is the entry in the middle.
using Profile = std::array<double, 2 * mostSteps + 1>;

template <class T>
Profile profileAt(const Field<T>& field, const glm::dvec3& place, const glm::dvec3& step) {
  Profile profile;
  double n = -mostSteps;
  for (double& value : profile)
    value = field.at(place + n++ * step);
  return profile;
}

// Whether the field changes as fast here as a voxel before and behind.
bool isSteepest(const Profile& profile) {
  const auto gain = [&](int n) { return profile[mostSteps + n + 1] - profile[mostSteps + n - 1]; };
  return gain(0) >= gain(-2) && gain(0) >= gain(2);
}

// Where the field stops changing, going up (`direction` 1) or down (-1).
double endOf(const Profile& profile, int direction) {
  double largest =
      std::max(profile[mostSteps + 1] - profile[mostSteps], profile[mostSteps] - profile[mostSteps - 1]);
  int n = mostSteps;
  for (; n + direction >= 0 && n + direction <= 2 * mostSteps; n += direction) {
    const int next = n + direction;
    const double gain =
        direction * (profile[static_cast<std::size_t>(next)] - profile[static_cast<std::size_t>(n)]);
    largest = std::max(largest, gain);
    if (gain <= standstill * largest)
      break;
  }
  return profile[static_cast<std::size_t>(n)];
}

// A step along a gradient that moves half a voxel along one axis and less along the others, in voxels.
glm::dvec3 stepAlong(const glm::dvec3& gradient, const glm::dvec3& spacingMm) {
  const glm::dvec3 inVoxels = gradient / spacingMm;
  return 0.5 * inVoxels /
         glm::max(glm::max(std::abs(inVoxels.x), std::abs(inVoxels.y)), std::abs(inVoxels.z));
}

// What the ranges from low to high have in common, as a part of what they span together.
double overlapOf(const Boundary& a, const Boundary& b) {
  const double common = std::min(a.high, b.high) - std::max(a.low, b.low);
  return common / (std::max(a.high, b.high) - std::min(a.low, b.low));
}

// Adds a boundary, the larger ones first, to the one that it is a part of, if there is such.
void add(const Boundary& boundary, std::vector<Boundary>& boundaries) {
  const auto same = std::ranges::find_if(
      boundaries, [&](const Boundary& other) { return overlapOf(boundary, other) > sameOverlap; });
  if (same == boundaries.end())
    boundaries.push_back(boundary);
  else
    same->share += boundary.share;
}

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

std::vector<LowHighPeak> peaksOf(std::vector<LowAndHigh> places) {
  if (places.empty())
    return {};
  // Sums of the same numbers in another order differ in their last bits.
  std::sort(places.begin(), places.end(), [](const LowAndHigh& a, const LowAndHigh& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  });
  const Axis axis = axisOf(places);
  Counts counts(std::size_t{histogramBins} * histogramBins, 0.0);
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
    if (std::abs(low - static_cast<int>(peak) % histogramBins) > 1 ||
        std::abs(high - static_cast<int>(peak) / histogramBins) > 1)
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

std::vector<Boundary> boundariesOf(const Volume& volume, const Effort& effort) {
  return boundariesOf(volume, KeptVoxels(volume.grid(), {}, {}), effort);
}

std::vector<Boundary> boundariesOf(const Volume& volume, const KeptVoxels& kept, const Effort& effort) {
  const Histogram moduli = gradientHistogram(volume, 4096, partOf(effort, 0.0, 0.5));
  const double least =
      std::max(weakest * quantile(moduli, strongestQuantile), overNoise * quantile(moduli, 0.5));
  if (!(moduli.range.highest > 0.0))
    return {};
  std::uint64_t strong = 0;
  for (std::size_t bin = 0; bin < moduli.counts.size(); ++bin)
    strong += valueOfBin(moduli, bin) >= least ? moduli.counts[bin] : 0;
  const std::uint64_t each = strong / mostPlaces + 1;

  std::vector<LowAndHigh> found;
  std::mutex mutex;
  const EligibleVoxels eligible(volume);
  const RowPieces rows(volume.grid().dims);
  visitVoxels(volume, [&]<class T>(const StoredVoxels<T>& stored) {
    const Stencil<T> stencil{volume, stored};
    const Field<T> field(volume, stored);
    shareOut(rows.pieces(), partOf(effort, 0.5, 1.0), [&](Pieces& pieces) {
      std::vector<LowAndHigh> own;
      const auto look = [&](int j, int k) {
        for (int i = 0; i < stencil.dims.x; ++i) {
          if (scattered(voxelOffset(stencil.dims, i, j, k)) % each != 0 || !kept.has(i, j, k) ||
              !eligible.has(i, j, k))
            continue;
          const glm::dvec3 gradient = stencil.alongAxes(i, j, k);
          if (!(glm::length(gradient) >= least))
            continue;
          const Profile profile = profileAt(field, {i, j, k}, stepAlong(gradient, volume.grid().spacingMm));
          if (isSteepest(profile))
            own.push_back({endOf(profile, -1), endOf(profile, 1)});
        }
      };
      for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
        rows.forEachRow(piece, look);
      const std::lock_guard lock(mutex);
      found.insert(found.end(), own.begin(), own.end());
    });
  });

  std::vector<Boundary> boundaries;
  for (const LowHighPeak& peak : peaksOf(std::move(found)))
    if (peak.share >= leastShare)
      add({peak.at.low, peak.at.high, peak.share}, boundaries);
  std::stable_sort(boundaries.begin(), boundaries.end(),
                   [](const Boundary& a, const Boundary& b) { return a.share > b.share; });
  return boundaries;
}

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
