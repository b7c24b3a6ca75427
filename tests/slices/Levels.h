// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/ReferenceIntegrator.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn::test {

/// The error of a picture as DEFINITION section 9 counts it, in 8-bit levels.
struct Levels {
  double mean = 0.0;
  double p999 = 0.0; ///< 99.9th percentile
  double largest = 0.0;
};

/// Over the four channels of the pixels that either picture covers.
inline Levels levelsBetween(const std::vector<glm::dvec4>& a, const std::vector<glm::dvec4>& b) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::max(a[i].a, b[i].a) >= 1.0 / 510.0)
      for (int channel = 0; channel < 4; ++channel)
        errors.push_back(255.0 * std::abs(a[i][channel] - b[i][channel]));
  if (errors.empty())
    return {};
  std::sort(errors.begin(), errors.end());
  Levels levels;
  for (const double error : errors)
    levels.mean += error / static_cast<double>(errors.size());
  const double place = 0.999 * static_cast<double>(errors.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, errors.size() - 1);
  levels.p999 = std::lerp(errors[below], errors[above], place - static_cast<double>(below));
  levels.largest = errors.back();
  return levels;
}

inline std::vector<glm::dvec4> toDouble(const Image& image) {
  return {image.pixels.begin(), image.pixels.end()};
}

} // namespace limn::test
