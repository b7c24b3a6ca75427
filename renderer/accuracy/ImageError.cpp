// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/ImageError.h"

#include "scene/PictureFigures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace limn {
namespace {

float levelsBetween(const glm::dvec4& a, const glm::dvec4& b) {
  if (!std::isnan(a.a) && !isCovered(glm::vec4(a)) && !isCovered(glm::vec4(b)))
    return -1.0f;
  double largest = 0.0;
  for (int channel = 0; channel < 4; ++channel) {
    const double difference = 255.0 * std::abs(a[channel] - b[channel]);
    if (std::isnan(difference))
      return std::numeric_limits<float>::infinity();
    largest = std::max(largest, difference);
  }
  return static_cast<float>(largest);
}

// By linear interpolation between the neighbours in rank; reorders the list.
double percentile(std::vector<double>& values, double share) {
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), at, values.end());
  const double fraction = place - static_cast<double>(below);
  if (fraction == 0.0)
    return *at;
  return std::lerp(*at, *std::min_element(at + 1, values.end()), fraction);
}

double levels(double difference) {
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::abs(difference) * 255.0;
}

} // namespace

ErrorMap errorMap(const Image& picture, const PrecisePixels& exact) {
  const PrecisePixels pixels = precise(picture);
  assert(pixels.size() == exact.size());
  ErrorMap map{picture.size, std::vector<float>(pixels.size())};
  std::transform(pixels.begin(), pixels.end(), exact.begin(), map.levels.begin(), levelsBetween);
  return map;
}

ImageError imageError(const PrecisePixels& picture, const PrecisePixels& exact) {
  assert(picture.size() == exact.size());
  std::vector<double> channels;
  std::size_t pixelsOverOne = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    // Not a number covers: it must not slip through a comparison.
    if (!(std::isnan(picture[i].a) || isCovered(glm::vec4(picture[i])) || isCovered(glm::vec4(exact[i]))))
      continue;
    double largest = 0.0;
    for (int c = 0; c < 4; ++c) {
      channels.push_back(levels(picture[i][c] - exact[i][c]));
      largest = std::max(largest, channels.back());
    }
    pixelsOverOne += largest > 1.0 ? 1 : 0;
  }
  if (channels.empty())
    return {};
  ImageError error;
  const auto count = static_cast<double>(channels.size());
  double squares = 0.0;
  for (const double channel : channels) {
    error.mean += channel / count;
    squares += channel * channel / count;
    error.largest = std::max(error.largest, channel);
  }
  error.rms = std::sqrt(squares);
  error.shareOverOne = 4.0 * static_cast<double>(pixelsOverOne) / count;
  error.p99_9 = percentile(channels, 0.999);
  return error;
}

ImageError imageError(const Image& picture, const PrecisePixels& exact) {
  return imageError(precise(picture), exact);
}

ImageError imageError(const Image& picture, const Image& other) {
  return imageError(precise(picture), precise(other));
}

PrecisePixels precise(const Image& image) {
  return {image.pixels.begin(), image.pixels.end()};
}

} // namespace limn
