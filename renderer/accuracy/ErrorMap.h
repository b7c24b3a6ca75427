// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ImageError.h"

namespace limn {

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
