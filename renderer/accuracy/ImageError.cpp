// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/ImageError.h"

#include "scene/PictureFigures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
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

// The largest of many values that are not below 0, as many as a percentile near 1 is told from: to keep all
// those of a large picture takes more memory than the picture, and longer than to compare it.
class LargestValues {
public:
  // The percentile (0 to 1) that is asked for, of so many values at most.
  LargestValues(double share, std::size_t most)
      : m_kept(static_cast<std::size_t>(std::ceil((1.0 - share) * static_cast<double>(most))) + 2) {}

  void add(double value) {
    ++m_count;
    if (value <= m_least)
      return;
    m_values.push_back(value);
    if (m_values.size() == 2 * m_kept)
      dropSmallest();
  }

  std::size_t count() const { return m_count; }
  const std::vector<double>& values() const { return m_values; }

  // By linear interpolation between the neighbours in rank; reorders the values, of which there is one.
  double percentile(double share) {
    const double place = share * static_cast<double>(m_count - 1);
    const auto below = static_cast<std::size_t>(place);
    assert(m_count - below <= m_values.size());
    const auto at = m_values.end() - static_cast<std::ptrdiff_t>(m_count - below);
    std::nth_element(m_values.begin(), at, m_values.end());
    const double fraction = place - static_cast<double>(below);
    if (fraction == 0.0)
      return *at;
    return std::lerp(*at, *std::min_element(at + 1, m_values.end()), fraction);
  }

private:
  void dropSmallest() {
    const auto first = m_values.begin() + static_cast<std::ptrdiff_t>(m_kept);
    std::nth_element(m_values.begin(), first - 1, m_values.end(), std::greater<>());
    m_values.erase(first, m_values.end());
    m_least = m_values.back();
  }

  std::size_t m_kept, m_count = 0;
  double m_least = -1.0;
  std::vector<double> m_values;
};

double levels(double difference) {
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : std::abs(difference) * 255.0;
}

// By how much the channels of covered pixels are off.
struct Channels {
  LargestValues levels;
  double sum = 0.0, squares = 0.0;
  double largest = 0.0;
  std::size_t pixelsOverOne = 0;
};

// Of single or double precision: to copy large pictures into the latter first takes longer than to compare
// them. The share is that of the percentile which will be asked for.
template <class Picture, class Exact>
Channels channelsOf(const Picture& picture, const Exact& exact, double share) {
  assert(picture.size() == exact.size());
  Channels channels{{share, 4 * picture.size()}};
  for (std::size_t i = 0; i < picture.size(); ++i) {
    // Not a number covers: it must not slip through a comparison.
    if (!(std::isnan(picture[i].a) || isCovered(glm::vec4(picture[i])) || isCovered(glm::vec4(exact[i]))))
      continue;
    const glm::dvec4 difference = glm::dvec4(picture[i]) - glm::dvec4(exact[i]);
    double largest = 0.0;
    for (int c = 0; c < 4; ++c) {
      const double level = levels(difference[c]);
      channels.levels.add(level);
      channels.sum += level;
      channels.squares += level * level;
      largest = std::max(largest, level);
    }
    channels.largest = std::max(channels.largest, largest);
    channels.pixelsOverOne += largest > 1.0 ? 1 : 0;
  }
  return channels;
}

// All 0 where nothing is covered.
ImageError withoutPercentile(const Channels& channels) {
  if (channels.levels.count() == 0)
    return {};
  const auto count = static_cast<double>(channels.levels.count());
  ImageError error;
  error.mean = channels.sum / count;
  error.rms = std::sqrt(channels.squares / count);
  error.largest = channels.largest;
  error.shareOverOne = 4.0 * static_cast<double>(channels.pixelsOverOne) / count;
  return error;
}

// Of the percentile that pictures are judged by.
constexpr double judged = 0.999;

template <class Picture, class Exact>
ImageError errorOf(const Picture& picture, const Exact& exact) {
  Channels channels = channelsOf(picture, exact, judged);
  ImageError error = withoutPercentile(channels);
  if (channels.levels.count() > 0)
    error.p99_9 = channels.levels.percentile(judged);
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
  return errorOf(picture, exact);
}

ImageError errorByTail(const Image& picture, const PrecisePixels& exact, double tail) {
  Channels channels = channelsOf(picture.pixels, exact, 1.0 - tail);
  ImageError error = withoutPercentile(channels);
  if (channels.levels.count() == 0)
    return error;
  const double least = channels.levels.percentile(1.0 - tail);
  double excess = 0.0;
  int count = 0;
  for (const double level : channels.levels.values())
    if (level > least) {
      excess += level - least;
      ++count;
    }
  // A tail of a few large errors among none is no exponential: no percentile lies above the largest.
  error.p99_9 =
      std::min(error.largest, least + (count > 0 ? std::log(tail / (1.0 - judged)) * excess / count : 0.0));
  return error;
}

ImageError imageError(const Image& picture, const PrecisePixels& exact) {
  return errorOf(picture.pixels, exact);
}

ImageError imageError(const Image& picture, const Image& other) {
  return errorOf(picture.pixels, other.pixels);
}

PrecisePixels precise(const Image& image) {
  return {image.pixels.begin(), image.pixels.end()};
}

} // namespace limn
