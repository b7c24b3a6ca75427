// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/Preset.h"

#include "scene/ProjectionFacts.h"
#include "scene/volume/Volume.h"

#include <algorithm>
#include <numeric>

namespace limn {
namespace {

/// Bins of a histogram that part it equally well.
struct BinRange {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t middle() const { return (first + last) / 2; }
};

// Of the bins below `end`: makes the variance between the two classes largest.
BinRange bestSplit(const Histogram& histogram, std::size_t end) {
  double total = 0.0;
  double sum = 0.0;
  for (std::size_t bin = 0; bin < end; ++bin) {
    total += static_cast<double>(histogram.counts[bin]);
    sum += static_cast<double>(histogram.counts[bin]) * static_cast<double>(bin);
  }
  double below = 0.0;
  double sumBelow = 0.0;
  double best = -1.0;
  BinRange split;
  for (std::size_t bin = 0; bin < end; ++bin) {
    below += static_cast<double>(histogram.counts[bin]);
    sumBelow += static_cast<double>(histogram.counts[bin]) * static_cast<double>(bin);
    const double above = total - below;
    if (below == 0.0 || above == 0.0)
      continue;
    const double difference = sumBelow / below - (sum - sumBelow) / above;
    const double variance = below * above * difference * difference;
    if (variance > best) {
      best = variance;
      split.first = bin;
    }
    if (variance == best)
      split.last = bin;
  }
  return split;
}

// Most voxels have the least value: whatever is darker was put there, as by a window of 8 bits.
bool isCutOffBelow(const Histogram& histogram) {
  const auto all = std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0});
  return histogram.counts.size() > 2 && 2 * histogram.counts.front() > all;
}

// More voxels have the greatest value than the one before it, but fewer than lie between the outermost two:
// whatever is brighter was put there, and pulls a split that soft tissue alone is to decide.
bool isSaturated(const Histogram& histogram) {
  const auto first = histogram.counts.begin() + 1, last = histogram.counts.end() - 1;
  return *last < std::accumulate(first, last, std::uint64_t{0}) && *last > *(last - 1);
}

// Voxels a bin around one, so that no comb of scaled values shows; not of the outermost two, which hold what
// lies beyond the scale.
double densityAround(const Histogram& histogram, std::size_t bin) {
  const std::size_t reach = std::max<std::size_t>(1, histogram.counts.size() / 128);
  const std::size_t from = bin > reach + 1 ? bin - reach : 1;
  const std::size_t to = std::min(bin + reach, histogram.counts.size() - 2);
  if (from > to)
    return 0.0;
  const auto first = histogram.counts.begin();
  const auto count = std::accumulate(first + static_cast<std::ptrdiff_t>(from),
                                     first + static_cast<std::ptrdiff_t>(to) + 1, std::uint64_t{0});
  return static_cast<double>(count) / static_cast<double>(to - from + 1);
}

double greatestDensity(const Histogram& histogram, std::size_t from, std::size_t to) {
  double greatest = 0.0;
  for (std::size_t bin = from; bin < to; ++bin)
    greatest = std::max(greatest, densityAround(histogram, bin));
  return greatest;
}

double between(const Histogram& histogram, const BinRange& split) {
  return (valueOfBin(histogram, split.first) + valueOfBin(histogram, split.last)) / 2.0;
}

// Whether a split parts bright voxels from the hump in whose tail they lie, as bone and contrast pull it up
// into that of soft tissue: beyond it nothing stands out (by twice), before it a hump does (by four times,
// and from the foot of what was cut off: what only falls from there on is no hump).
bool partsTail(const Histogram& histogram, std::size_t split) {
  const double there = densityAround(histogram, split);
  const double hump = greatestDensity(histogram, 1, split);
  return greatestDensity(histogram, split, histogram.counts.size()) < 2.0 * there && hump > 4.0 * there &&
         hump > densityAround(histogram, 1);
}

// Where tissue begins: the threshold that best separates it from the background, but of a scale that was cut
// off, which is what a window of 8 bits does, not in the tail of tissue.
double beginOfObject(const Histogram& histogram) {
  if (!isCutOffBelow(histogram))
    return objectThreshold(histogram);
  BinRange split = bestSplit(histogram, histogram.counts.size() - (isSaturated(histogram) ? 1 : 0));
  while (partsTail(histogram, split.middle()))
    split = bestSplit(histogram, split.middle() + 1);
  return between(histogram, split);
}

} // namespace

Landmarks landmarksOf(const Histogram& histogram) {
  const double least = binWidth(histogram) > 0.0 ? binWidth(histogram) : 1.0;
  const double low = quantile(histogram, 0.005);
  const double high = std::max(quantile(histogram, 0.998), low + 2.0 * least);
  return {low, std::clamp(beginOfObject(histogram), low + least, high - least), high};
}

double moved(double value, const Landmarks& from, const Landmarks& to) {
  const bool isBelow = value < from.object;
  const double share = isBelow ? (value - from.background) / (from.object - from.background)
                               : (value - from.object) / (from.brightest - from.object);
  return isBelow ? to.background + share * (to.object - to.background)
                 : to.object + share * (to.brightest - to.object);
}

TransferFunction moved(const TransferFunction& function, const Landmarks& from, const Landmarks& to) {
  TransferFunction result = function;
  for (ControlPoint& point : result.points)
    point.value = moved(point.value, from, to);
  return result;
}

double objectThreshold(const Histogram& histogram) {
  return between(histogram, bestSplit(histogram, histogram.counts.size()));
}

Preset presetOf(const Scene& scene, const std::string& name) {
  Preset preset;
  preset.name = name;
  if (scene.volume)
    preset.modality = scene.volume->info().modality;
  preset.transferFunction = scene.transferFunction;
  preset.gradientOpacity = scene.gradientOpacity;
  preset.shading = scene.shading;
  preset.projection = scene.projection;
  if (showsSurface(scene.projection))
    preset.isovalue = scene.isovalue;
  return preset;
}

Scene withPreset(const Scene& scene, const Preset& preset, bool keepModel) {
  Scene shown = scene;
  shown.transferFunction = preset.transferFunction;
  shown.gradientOpacity = preset.gradientOpacity;
  if (preset.shading) {
    shown.shading = *preset.shading;
    shown.shading.physical.until = scene.shading.physical.until;
    shown.shading.physical.filtersNoise = scene.shading.physical.filtersNoise;
  }
  if (!preset.isWhole && !(shown.shading.gradientSmoothing > 0.0))
    shown.shading.gradientSmoothing = scene.shading.gradientSmoothing;
  if (keepModel)
    shown.shading.model = scene.shading.model;
  if (preset.projection)
    shown.projection = *preset.projection;
  if (preset.isovalue)
    shown.isovalue = *preset.isovalue;
  return shown;
}

} // namespace limn
