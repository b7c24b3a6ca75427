// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/PresetFit.h"

#include "scene/light/GradientSmoothing.h"

#include <algorithm>
#include <cmath>

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

// Scanners of people have voxels of a tenth of a millimetre and more; below that lie samples of a few
// millimetres, through which one would see as through a film.
constexpr double finestOfBodiesMm = 0.1;

const Preset* named(const std::vector<Preset>& presets, const std::string& name) {
  const auto found =
      std::find_if(presets.begin(), presets.end(), [&](const Preset& p) { return p.name == name; });
  return found == presets.end() ? nullptr : &*found;
}

// Lungs fill a good part of a chest, and nothing else has so many voxels between air and fat.
bool holdsLungs(const Histogram& histogram) {
  double lung = 0.0;
  double body = 0.0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const double value = valueOfBin(histogram, bin);
    const auto count = static_cast<double>(histogram.counts[bin]);
    lung += value >= -900.0 && value < -600.0 ? count : 0.0;
    body += value >= -300.0 ? count : 0.0;
  }
  return lung > 0.15 * body;
}

// A brain whose skull was masked away: most voxels have the least value, and nearly none of the others lies
// just above it, as noise and skin do around a head. The brain's own values are many; a label map has few.
bool holdsBrainAlone(const Histogram& histogram) {
  const double low = valueOfBin(histogram, 0);
  const double dark = low + 0.15 * (quantile(histogram, 0.998) - low);
  double darkVoxels = 0.0;
  double others = 0.0;
  int values = 0;
  for (std::size_t bin = 1; bin < histogram.counts.size(); ++bin) {
    const auto count = static_cast<double>(histogram.counts[bin]);
    others += count;
    darkVoxels += valueOfBin(histogram, bin) < dark ? count : 0.0;
    values += count > 0.0 ? 1 : 0;
  }
  const auto masked = static_cast<double>(histogram.counts[0]);
  return masked >= 0.6 * (masked + others) && darkVoxels < 0.01 * others && values > 32;
}

// Three standard deviations above the mean of what lies below the threshold: noise around an object ends
// there.
double endOfBackground(const Histogram& histogram, double threshold) {
  double count = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const double value = valueOfBin(histogram, bin);
    if (value >= threshold)
      break;
    const auto voxels = static_cast<double>(histogram.counts[bin]);
    count += voxels;
    sum += voxels * value;
    squares += voxels * value * value;
  }
  if (count == 0.0)
    return threshold;
  const double mean = sum / count;
  return mean + 3.0 * std::sqrt(std::max(0.0, squares / count - mean * mean));
}

const char* firstLookOfHounsfield(const ScanHints& hints, const Histogram& histogram) {
  if (hints.isAngiography)
    return "CT angiography";
  const bool isChest = hints.bodyPart == ScanHints::BodyPart::chest ||
                       (hints.bodyPart == ScanHints::BodyPart::unknown && holdsLungs(histogram));
  return isChest ? "CT chest" : "CT bone and veil";
}

const char* firstLookOfMr(const ScanHints& hints, const Histogram& histogram) {
  if (hints.isAngiography)
    return "Vessels";
  const bool mayBeT1 =
      hints.weighting == ScanHints::Weighting::unknown || hints.weighting == ScanHints::Weighting::t1;
  if (mayBeT1 && holdsBrainAlone(histogram))
    return "MR skull-stripped brain";
  return hints.weighting == ScanHints::Weighting::t2   ? "MR T2 head"
         : hints.weighting == ScanHints::Weighting::pd ? "MR PD head"
                                                       : "MR head";
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

std::string firstLook(const Volume& volume, const Histogram& histogram) {
  const ScanHints& hints = volume.info().hints;
  if (looksLikeHounsfield(volume))
    return firstLookOfHounsfield(hints, histogram);
  if (hints.isAngiography)
    return "Vessels";
  const std::string& modality = volume.info().modality.empty() ? hints.modality : volume.info().modality;
  if (modality == "CT")
    return hints.bodyPart == ScanHints::BodyPart::chest ? "CT chest" : "CT bone and veil";
  if (modality == "MR")
    return firstLookOfMr(hints, histogram);
  if (modality == "PT")
    return "PET hot spots";
  if (modality == "US")
    return "Ultrasound surface";
  // A head in a scale of its own was commonly taken by MR; NIfTI is the format of those who strip skulls.
  const bool isHead = hints.bodyPart == ScanHints::BodyPart::head;
  const bool mayBeBrain = isHead || volume.info().format.starts_with("NIfTI");
  if (modality.empty() && mayBeBrain && holdsBrainAlone(histogram))
    return "MR skull-stripped brain";
  return modality.empty() && isHead ? "MR head" : "";
}

bool looksLikeHounsfield(const Volume& volume) {
  if (volume.info().unit == "HU")
    return true;
  if (!volume.info().modality.empty() && volume.info().modality != "CT")
    return false;
  const ValueRange range = volume.range();
  return range.lowest >= -3100.0 && range.lowest <= -900.0 && range.highest > 150.0;
}

double unitDistanceMm(const Grid& grid) {
  return std::min(1.0, smallestSpacingMm(grid));
}

TransferFunction automaticRamp(const Histogram& histogram, const Grid& grid) {
  const Landmarks landmarks = landmarksOf(histogram);
  const double low = histogram.range.lowest;
  const double high = std::max(quantile(histogram, 0.995), low + binWidth(histogram));
  const double threshold = std::clamp(landmarks.object, low, high);
  // Skin is darker than what it covers: the ramp begins below the threshold, but above noise.
  const double begin = std::clamp(endOfBackground(histogram, threshold), low + 0.6 * (threshold - low),
                                  low + 0.9 * (threshold - low));
  return {unitDistanceMm(grid),
          {{begin, {0.62, 0.44, 0.34}, 0.0},
           {threshold, {0.78, 0.58, 0.45}, 0.25},
           {threshold + 0.35 * (high - threshold), {0.90, 0.75, 0.59}, 0.5},
           {high, {1.0, 0.98, 0.94}, 0.85}}};
}

Preset fittedTo(const Preset& preset, const Histogram& histogram, const Grid& grid) {
  Preset fitted = preset;
  double& unit = fitted.transferFunction.unitDistanceMm;
  if (smallestSpacingMm(grid) < finestOfBodiesMm)
    unit = std::min(unit, unitDistanceMm(grid)); // the same once more where it was fitted before
  if (!preset.landmarks)
    return fitted;
  fitted.landmarks = landmarksOf(histogram);
  fitted.transferFunction = moved(fitted.transferFunction, *preset.landmarks, *fitted.landmarks);
  if (preset.isovalue)
    fitted.isovalue = moved(*preset.isovalue, *preset.landmarks, *fitted.landmarks);
  return fitted;
}

bool isForHounsfield(const Preset& preset) {
  return preset.modality == "CT" && !preset.landmarks;
}

Preset withLandmarks(Preset preset) {
  if (isForHounsfield(preset))
    preset.landmarks = hounsfieldLandmarks;
  return preset;
}

Preset withoutSmoothingOfSlices(Preset preset, const Grid& grid) {
  if (preset.shading && preset.shading->gradientSmoothing == smoothingOfSlices(grid))
    preset.shading->gradientSmoothing = 0.0;
  return preset;
}

Preset fittedToValues(const Preset& preset, const Volume& volume, const Histogram& histogram) {
  return fittedTo(looksLikeHounsfield(volume) ? preset : withLandmarks(preset), histogram, volume.grid());
}

Preset bestFitting(const std::vector<Preset>& builtIn, const Volume& volume, const Effort& effort) {
  const Histogram histogram = histogramOf(volume, 1024, effort);
  if (imageNormalAxis(volume.grid()))
    return imageLook(volume, histogram);
  if (const Preset* preset = named(builtIn, firstLook(volume, histogram)))
    return fittedTo(looksLikeHounsfield(volume) ? *preset : withLandmarks(*preset), histogram, volume.grid());
  Preset automatic;
  automatic.name = "Automatic";
  automatic.modality = volume.info().modality;
  automatic.note = "Transparent background, brighter values more opaque";
  automatic.transferFunction = automaticRamp(histogram, volume.grid());
  // Opaque surfaces would lose their shape in full highlights, and their colour in light that adds up to
  // more than 1.
  automatic.shading = Shading{};
  automatic.shading->specular = 0.2;
  automatic.shading->exponent = 24.0;
  automatic.shading->ambientIntensity = 0.28;
  automatic.shading->lightIntensity = 0.7;
  return automatic;
}

} // namespace limn
