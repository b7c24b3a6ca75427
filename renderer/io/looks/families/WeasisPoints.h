// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/json/JsonFields.h"
#include "io/looks/Look.h"
#include "io/looks/curves/LookLight.h"

#include <utility>
#include <vector>

namespace limn {

/// A number of Weasis, which may be a text; false where it is absent or null. Throws Error (input) where it
/// is no finite number.
bool weasisNumber(JsonFields& fields, const std::string& key, double& target);

/// A flag, which may be a text.
bool weasisFlag(JsonFields& fields, const std::string& key, bool absent);

/// The points of a look of Weasis: those with an opacity, those with a colour, and the light of those that
/// have one.
struct WeasisPoints {
  std::vector<ControlPoint> opacity;
  std::vector<ControlPoint> color;
  std::vector<std::pair<glm::dvec3, double>> lights; ///< ambient, diffuse and specular; opacity of the point

  /// Adds the light that the fields of a point say, if any.
  void addLight(JsonFields& fields, double pointOpacity);
};

/// One light for all points: theirs where they agree, otherwise their mean, weighted by opacity, which is
/// told. Without any, what Weasis takes then.
HeadLight weasisLight(const WeasisPoints& points, std::vector<Message>& changes);

/// The function of the points, checked and sorted, which is told where it changes something.
TransferFunction weasisFunction(WeasisPoints points, const std::string& file, std::vector<Message>& changes);

} // namespace limn
