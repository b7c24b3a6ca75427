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

// By how much the channels of covered pixels are off.
struct Channels {
  std::vector<double> levels;
  std::size_t pixelsOverOne = 0;
};

// Of single or double precision: to copy large pictures into the latter first takes longer than to compare
// them.
template <class Picture, class Exact>
Channels channelsOf(const Picture& picture, const Exact& exact) {
  assert(picture.size() == exact.size());
  Channels channels;
  channels.levels.reserve(4 * picture.size());
  for (std::size_t i = 0; i < picture.size(); ++i) {
    // Not a number covers: it must not slip through a comparison.
    if (!(std::isnan(picture[i].a) || isCovered(glm::vec4(picture[i])) || isCovered(glm::vec4(exact[i]))))
      continue;
    const glm::dvec4 difference = glm::dvec4(picture[i]) - glm::dvec4(exact[i]);
    double largest = 0.0;
    for (int c = 0; c < 4; ++c) {
      channels.levels.push_back(levels(difference[c]));
      largest = std::max(largest, channels.levels.back());
    }
    channels.pixelsOverOne += largest > 1.0 ? 1 : 0;
  }
  return channels;
}

// All 0 where nothing is covered.
ImageError withoutPercentile(const Channels& channels) {
  ImageError error;
  const auto count = static_cast<double>(channels.levels.size());
  double squares = 0.0;
  for (const double level : channels.levels) {
    error.mean += level / count;
    squares += level * level / count;
    error.largest = std::max(error.largest, level);
  }
  error.rms = std::sqrt(squares);
  if (!channels.levels.empty())
    error.shareOverOne = 4.0 * static_cast<double>(channels.pixelsOverOne) / count;
  return error;
}

ImageError errorOf(Channels channels) {
  ImageError error = withoutPercentile(channels);
  if (!channels.levels.empty())
    error.p99_9 = percentile(channels.levels, 0.999);
  return error;
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
  return errorOf(channelsOf(picture, exact));
}

ImageError errorByTail(const Image& picture, const PrecisePixels& exact, double tail) {
  Channels channels = channelsOf(picture.pixels, exact);
  ImageError error = withoutPercentile(channels);
  if (channels.levels.empty())
    return error;
  const double least = percentile(channels.levels, 1.0 - tail);
  double excess = 0.0;
  int count = 0;
  for (const double level : channels.levels)
    if (level > least) {
      excess += level - least;
      ++count;
    }
  // A tail of a few large errors among none is no exponential: no percentile lies above the largest.
  error.p99_9 = std::min(error.largest, least + (count > 0 ? std::log(tail / 0.001) * excess / count : 0.0));
  return error;
}

ImageError imageError(const Image& picture, const PrecisePixels& exact) {
  return errorOf(channelsOf(picture.pixels, exact));
}

ImageError imageError(const Image& picture, const Image& other) {
  return errorOf(channelsOf(picture.pixels, other.pixels));
}

PrecisePixels precise(const Image& image) {
  return {image.pixels.begin(), image.pixels.end()};
}

} // namespace limn
