// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace limn {

/// A rectangle of pixels, y down from the top of the picture.
struct PixelRect {
  glm::ivec2 topLeft{0};
  glm::ivec2 size{0};
  bool operator==(const PixelRect&) const = default;
};

} // namespace limn
