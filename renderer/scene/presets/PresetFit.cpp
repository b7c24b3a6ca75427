// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/PresetFit.h"

#include <algorithm>

namespace limn {
namespace {

const Preset* named(const std::vector<Preset>& presets, const std::string& name) {
  const auto found =
      std::find_if(presets.begin(), presets.end(), [&](const Preset& p) { return p.name == name; });
  return found == presets.end() ? nullptr : &*found;
}

} // namespace

bool looksLikeHounsfield(const Volume& volume) {
  if (volume.info().unit == "HU")
    return true;
  if (!volume.info().modality.empty() && volume.info().modality != "CT")
    return false;
  const ValueRange range = volume.range();
  return range.lowest >= -3100.0 && range.lowest <= -900.0 && range.highest > 150.0;
}

double objectThreshold(const Histogram& histogram) {
  // Make the variance between the two classes largest; take the middle where several do.
  double total = 0.0;
  double sum = 0.0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    total += static_cast<double>(histogram.counts[bin]);
    sum += static_cast<double>(histogram.counts[bin]) * static_cast<double>(bin);
  }
  double below = 0.0;
  double sumBelow = 0.0;
  double best = -1.0;
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    below += static_cast<double>(histogram.counts[bin]);
    sumBelow += static_cast<double>(histogram.counts[bin]) * static_cast<double>(bin);
    const double above = total - below;
    if (below == 0.0 || above == 0.0)
      continue;
    const double difference = sumBelow / below - (sum - sumBelow) / above;
    const double variance = below * above * difference * difference;
    if (variance > best) {
      best = variance;
      first = bin;
    }
    if (variance == best)
      last = bin;
  }
  return (valueOfBin(histogram, first) + valueOfBin(histogram, last)) / 2.0;
}

TransferFunction automaticRamp(const Histogram& histogram) {
  const double low = histogram.range.lowest;
  const double high = std::max(quantile(histogram, 0.995), low + binWidth(histogram));
  // Skin is darker than what it covers: the ramp begins below the threshold.
  const double threshold = std::clamp(low + 0.6 * (objectThreshold(histogram) - low), low, high);
  const double knee = threshold + 0.35 * (high - threshold);
  return {1.0,
          {{threshold, {0.74, 0.52, 0.42}, 0.0},
           {knee, {0.92, 0.76, 0.62}, 0.10},
           {high, {1.0, 0.97, 0.90}, 0.6}}};
}

Preset fittedTo(const Preset& preset, const Histogram& histogram) {
  const auto& points = preset.transferFunction.points;
  if (preset.modality == "CT" || points.size() < 2 || points.front().value == points.back().value)
    return preset;
  const double low = quantile(histogram, 0.005);
  const double high = quantile(histogram, 0.998);
  if (!(high > low))
    return preset;
  Preset fitted = preset;
  const double first = points.front().value;
  const double scale = (high - low) / (points.back().value - first);
  for (ControlPoint& point : fitted.transferFunction.points)
    point.value = low + (point.value - first) * scale;
  return fitted;
}

Preset bestFitting(const std::vector<Preset>& builtIn, const Volume& volume, const Effort& effort) {
  if (looksLikeHounsfield(volume)) {
    if (const Preset* preset = named(builtIn, "CT skin and bone"))
      return *preset;
  } else if (volume.info().modality == "MR") {
    if (const Preset* preset = named(builtIn, "MR head"))
      return fittedTo(*preset, histogramOf(volume, 1024, effort));
  }
  Preset automatic;
  automatic.name = "Automatic";
  automatic.modality = volume.info().modality;
  automatic.note = "Transparent background, brighter values more opaque";
  automatic.transferFunction = automaticRamp(histogramOf(volume, 1024, effort));
  return automatic;
}

} // namespace limn
