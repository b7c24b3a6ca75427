// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/ErrorMap.h"

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

} // namespace

ErrorMap errorMap(const Image& picture, const PrecisePixels& exact) {
  const PrecisePixels pixels = precise(picture);
  assert(pixels.size() == exact.size());
  ErrorMap map{picture.size, std::vector<float>(pixels.size())};
  std::transform(pixels.begin(), pixels.end(), exact.begin(), map.levels.begin(), levelsBetween);
  return map;
}

} // namespace limn
