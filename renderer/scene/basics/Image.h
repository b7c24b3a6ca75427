// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <cassert>
#include <cstddef>
#include <vector>

namespace limn {

/// A picture in floats: premultiplied RGBA without background, rows from top to bottom.
struct Image {
  glm::ivec2 size{0};
  std::vector<glm::vec4> pixels; ///< size.x · size.y, row by row

  Image() = default;
  explicit Image(const glm::ivec2& pixelSize)
      : size(pixelSize), pixels(static_cast<std::size_t>(pixelSize.x) * pixelSize.y, glm::vec4(0.0f)) {}

  glm::vec4& at(int x, int y) {
    assert(x >= 0 && x < size.x && y >= 0 && y < size.y);
    return pixels[static_cast<std::size_t>(y) * size.x + x];
  }
  const glm::vec4& at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }

  bool operator==(const Image&) const = default;
};

} // namespace limn
