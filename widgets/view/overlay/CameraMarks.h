// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

#include <string>

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

/// The anatomical directions at the four edges of a picture, as letters: R right, L left, A anterior,
/// P posterior, S superior, I inferior; several where the view is oblique, the strongest first.
struct OrientationLetters {
  std::string left, right, top, bottom;
  bool operator==(const OrientationLetters&) const = default;
};

/// The letters of a world direction (LPS): every axis within 75° of it, the nearest first.
std::string lettersOf(const glm::dvec3& direction);

/// The letters at the edges of the camera's picture.
OrientationLetters orientationLetters(const Camera& camera);

} // namespace limn
