// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/ImageLook.h"

#include "scene/presets/PresetFit.h"

#include <algorithm>

namespace limn {
namespace {

constexpr ValueRange softTissue{-160.0, 240.0};

ValueRange windowOf(const Volume& volume, const Histogram& histogram) {
  const double low = quantile(histogram, 0.005);
  const double high = quantile(histogram, 0.995);
  if (looksLikeHounsfield(volume) && low < softTissue.highest && high > softTissue.lowest)
    return softTissue;
  const double least = binWidth(histogram) > 0.0 ? binWidth(histogram) : 1.0;
  return {low, std::max(high, low + least)};
}

} // namespace

Preset imageLook(const Volume& volume, const Histogram& histogram) {
  const ValueRange window = windowOf(volume, histogram);
  Preset look;
  look.name = "Image";
  look.modality = volume.info().modality;
  look.note = "Grey values of a single image";
  // Opaque before a ray has drifted sideways: an image may be thicker than its pixels are wide.
  look.transferFunction = {unitDistanceMm(volume.grid()),
                           {{window.lowest, glm::dvec3(0.0), 1.0}, {window.highest, glm::dvec3(1.0), 1.0}}};
  look.shading = Shading{};
  look.shading->model = ShadingModel::none;
  look.projection = Projection::composite;
  return look;
}

} // namespace limn
