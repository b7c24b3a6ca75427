// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

#include <QString>

#include <optional>

namespace limn {

class CompareView;

/// A place about which a picture can be turned, or why there is none.
struct TurnCentre {
  std::optional<glm::dvec3> placeMm; ///< world
  QString reason;                    ///< one sentence where there is no place
};

/// Where half of what a ray of the picture of `side` gives is gathered (halfLightDepth): what is seen there.
TurnCentre turnCentreAlong(const CompareView& view, const Ray& ray, int side);

/// That nothing is seen where something was pointed at.
QString noPlaceText();

} // namespace limn
