// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Image.h"

#include <vector>

namespace limn {

/// How far a picture lies from another, in 8-bit levels (premultiplied channels × 255, not quantised), over
/// the four channels of the pixels that either covers (DEFINITION section 9). All 0 where none is covered.
struct ImageError {
  double largest = 0.0;
  double p99_9 = 0.0; ///< 99.9th percentile of the channels, linearly interpolated
  double mean = 0.0;
  double rms = 0.0;
  double shareOverOne = 0.0; ///< of those pixels, off by more than one level in any channel; 0..1
  bool operator==(const ImageError&) const = default;
};

/// A picture in double precision, rows from the top.
using PrecisePixels = std::vector<glm::dvec4>;

/// Both pictures have the same number of pixels. A channel that is not a number counts as infinitely wrong.
ImageError imageError(const PrecisePixels& picture, const PrecisePixels& exact);
ImageError imageError(const Image& picture, const PrecisePixels& exact);
ImageError imageError(const Image& picture, const Image& other);

/// The same from few pixels, for a picture of many: the 99.9th percentile is told by the share of the
/// channels that is off most, 0.001 < `tail` < 1, whose excess is taken to fall off exponentially. It
/// scatters half as much as one between the last two or three channels.
ImageError errorByTail(const Image& picture, const PrecisePixels& exact, double tail);

/// The pixels of a picture, premultiplied RGBA, rows from the top.
PrecisePixels precise(const Image& image);

/// Where a picture lies how far from the exact one.
struct ErrorMap {
  glm::ivec2 size{0};
  /// Rows from the top: of each pixel the largest difference of its premultiplied channels, in 8-bit levels;
  /// less than 0 where neither picture covers it.
  std::vector<float> levels;
  bool operator==(const ErrorMap&) const = default;
};

/// Both pictures have the same number of pixels.
ErrorMap errorMap(const Image& picture, const PrecisePixels& exact);

} // namespace limn
