// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/PictureFigures.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limn {
namespace {

// The function with a step of colour, not of opacity, at the value: black below, white from there on.
TransferFunction blackBelow(const TransferFunction& function, double value) {
  TransferFunction colored{function.unitDistanceMm, {}};
  const auto add = [&colored](double at, double brightness, double opacity) {
    colored.points.push_back({at, glm::dvec3(brightness), opacity});
  };
  const auto step = std::find_if(function.points.begin(), function.points.end(),
                                 [value](const ControlPoint& point) { return point.value >= value; });
  for (auto point = function.points.begin(); point != step; ++point)
    add(point->value, 0.0, point->opacity);
  const bool isAtPoint = step != function.points.end() && step->value == value;
  const double opacity = isAtPoint ? step->opacity : classify(function, value).opacity;
  add(value, 0.0, opacity);
  add(value, 1.0, opacity);
  for (auto point = step; point != function.points.end(); ++point)
    add(point->value, 1.0, point->opacity);
  return colored;
}

} // namespace

bool isCovered(const glm::vec4& pixel) {
  return pixel.a >= 1.0f / 510.0f;
}

Overflow overflowOf(const Image& unlimited) {
  std::size_t covered = 0;
  std::size_t over = 0;
  double sum = 0.0;
  for (const glm::vec4& pixel : unlimited.pixels) {
    if (!isCovered(pixel))
      continue;
    ++covered;
    const double largest = std::max({pixel.r, pixel.g, pixel.b});
    if (largest > 1.0) {
      ++over;
      sum += largest - 1.0;
    }
  }
  if (over == 0)
    return {};
  return {static_cast<double>(over) / static_cast<double>(covered), sum / static_cast<double>(over)};
}

PictureChange changeBetween(const Image& picture, const Image& other) {
  assert(picture.size == other.size);
  PictureChange change;
  std::size_t channels = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (!isCovered(picture.pixels[i]) && !isCovered(other.pixels[i]))
      continue;
    for (int channel = 0; channel < 4; ++channel) {
      const double levels = 255.0 * std::abs(double{picture.pixels[i][channel]} - other.pixels[i][channel]);
      change.mostLevels = std::max(change.mostLevels, levels);
      sum += levels;
    }
    channels += 4;
  }
  if (channels > 0)
    change.meanLevels = sum / static_cast<double>(channels);
  return change;
}

double contrastOf(const Image& image) {
  std::size_t covered = 0;
  double sum = 0.0;
  double squares = 0.0;
  for (const glm::vec4& pixel : image.pixels) {
    if (!isCovered(pixel))
      continue;
    const double luminance = 0.2126 * pixel.r + 0.7152 * pixel.g + 0.0722 * pixel.b;
    ++covered;
    sum += luminance;
    squares += luminance * luminance;
  }
  if (covered == 0)
    return 0.0;
  const double mean = sum / static_cast<double>(covered);
  return std::sqrt(std::max(0.0, squares / static_cast<double>(covered) - mean * mean));
}

TissueScenes tissueScenes(const Scene& scene) {
  TissueScenes scenes{scene, scene};
  scenes.weights.transferFunction = blackBelow(scene.transferFunction, scene.isovalue);
  for (TransferFunction& look : scenes.weights.keep.looks)
    look = blackBelow(look, scene.isovalue);
  scenes.weights.projection = Projection::composite;
  scenes.weights.fog = {};
  // Without a knee the ambient term alone is the material's colour, whatever the model does to opacity.
  Shading& shading = scenes.weights.shading;
  shading.ambient = 1.0;
  shading.ambientIntensity = 1.0;
  shading.diffuse = 0.0;
  shading.specular = 0.0;
  shading.knee.reset();
  scenes.surface.projection = Projection::isosurface;
  scenes.surface.shading.model = ShadingModel::none;
  return scenes;
}

double visibleShare(const Image& weights, const Image& surface) {
  assert(weights.size == surface.size);
  std::size_t met = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.pixels.size(); ++i)
    if (isCovered(surface.pixels[i])) {
      ++met;
      sum += weights.pixels[i].r;
    }
  return met > 0 ? sum / static_cast<double>(met) : 0.0;
}

} // namespace limn
