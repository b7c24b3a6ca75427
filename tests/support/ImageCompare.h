// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/ReferenceIntegrator.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace limn::test {

/// Differences of premultiplied channels in 8-bit levels (DEFINITION section 9, before quantising).
struct Difference {
  double largest = 0.0;
  double mean = 0.0; ///< over the four channels of pixels that either picture covers (alpha ≥ 1/510)
  glm::ivec2 worst{-1};
  std::size_t pixels = 0;
};

inline std::ostream& operator<<(std::ostream& stream, const Difference& d) {
  return stream << "largest " << d.largest << " levels at (" << d.worst.x << ", " << d.worst.y << "), mean "
                << d.mean << " over " << d.pixels << " pixels";
}

/// A float picture against the reference over the pixels that `isCounted(index)` admits.
template <class Predicate>
Difference differenceOf(const Image& image, const ReferencePicture& reference, Predicate isCounted) {
  Difference result;
  double sum = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (!isCounted(i))
      continue;
    const glm::dvec4 error = glm::abs(glm::dvec4(image.pixels[i]) - reference.pixels[i]) * 255.0;
    const double largest = std::max({error.r, error.g, error.b, error.a});
    if (!(largest <= result.largest)) {
      result.largest = largest;
      result.worst = {static_cast<int>(i) % image.size.x, static_cast<int>(i) / image.size.x};
    }
    if (std::max<double>(image.pixels[i].a, reference.pixels[i].a) < 1.0 / 510.0)
      continue;
    sum += error.r + error.g + error.b + error.a;
    ++result.pixels;
  }
  result.mean = result.pixels > 0 ? sum / (4.0 * static_cast<double>(result.pixels)) : 0.0;
  return result;
}

} // namespace limn::test
