// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/RayFrame.h"

#include <glm/glm.hpp>

namespace limn {

/// A rectangle of pixels, y down from the top of the picture.
struct PixelRect {
  glm::ivec2 topLeft{0};
  glm::ivec2 size{0};
  bool operator==(const PixelRect&) const = default;
};

/// A rectangle that holds every pixel of a picture of `size` whose ray meets a box (centred index
/// coordinates); the whole picture where the box reaches behind the eye. A software driver spends on each
/// pixel outside it what one shaded sample costs.
PixelRect coveredPixels(const Camera& camera, const Grid& grid, const IndexBox& box, const glm::ivec2& size);

/// What two rectangles share; its size is 0 where they share nothing.
PixelRect intersection(const PixelRect& a, const PixelRect& b);

} // namespace limn
