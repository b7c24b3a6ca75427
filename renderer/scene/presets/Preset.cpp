// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/Preset.h"

#include "scene/ProjectionFacts.h"
#include "scene/volume/Volume.h"

#include <algorithm>

namespace limn {

Landmarks landmarksOf(const Histogram& histogram) {
  const double least = binWidth(histogram) > 0.0 ? binWidth(histogram) : 1.0;
  const double low = quantile(histogram, 0.005);
  const double high = std::max(quantile(histogram, 0.998), low + 2.0 * least);
  return {low, std::clamp(objectThreshold(histogram), low + least, high - least), high};
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
  if (preset.shading)
    shown.shading = *preset.shading;
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
