// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PixelRect.h"
#include "scene/steps/RayFrame.h"

namespace limn {

/// A rectangle that holds every pixel of a picture of `size` whose ray meets a box (centred index
/// coordinates); the whole picture where the box reaches behind the eye. A software driver spends on each
/// pixel outside it what one shaded sample costs.
PixelRect coveredPixels(const Camera& camera, const Grid& grid, const IndexBox& box, const glm::ivec2& size);

/// What two rectangles share; its size is 0 where they share nothing.
PixelRect intersection(const PixelRect& a, const PixelRect& b);

} // namespace limn
