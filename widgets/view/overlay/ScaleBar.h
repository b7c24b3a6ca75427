// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

namespace limn {

/// A bar of a round length.
struct ScaleBar {
  double lengthMm = 0.0; ///< 1, 2 or 5 times a power of ten
  double pixels = 0.0;
};

/// Millimetres per pixel of a picture `heightPixels` high, in the plane of the camera's target.
double mmPerPixel(const Camera& camera, double heightPixels);

/// The longest bar of a round length that is at most `mostPixels` long.
ScaleBar scaleBar(double mmPerPixel, double mostPixels);

} // namespace limn
