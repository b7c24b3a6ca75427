// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

#include <string>

namespace limn {

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
