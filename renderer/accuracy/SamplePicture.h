// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Image.h"

#include <vector>

namespace limn {

/// How many samples the rays of a picture took. Rays that took none count for nothing.
struct SampleFigures {
  int least = 0;
  int most = 0;
  double mean = 0.0;
  bool operator==(const SampleFigures&) const = default;
};

/// `samples` of each ray of a picture, ≥ 0; all figures are 0 where none took any.
SampleFigures figuresOf(const std::vector<int>& samples);

/// Samples per pixel as a picture, opaque: from black for none over blue and red to pale yellow for the most,
/// the lightness in proportion.
Image pictureOfSamples(const std::vector<int>& samples, const glm::ivec2& size);

/// The colour of a share 0..1 on that scale, whose lightness as people see it (Oklab, Ottosson 2020) grows
/// evenly; sRGB-encoded.
glm::dvec3 colorOfShare(double share);

/// A colour of Oklab (Ottosson, "A perceptual color space for image processing", 2020), sRGB-encoded and
/// limited to what sRGB has.
glm::dvec3 srgbOfOklab(double lightness, double a, double b);

} // namespace limn
