// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/families/WeasisPoints.h"

#include "io/looks/curves/LookCurves.h"
#include "io/reading/HeaderText.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

const glm::dvec3 usualLight(0.2, 0.9, 0.2); // what Weasis takes for ambient, diffuse and specular if absent

bool ascend(const std::vector<ControlPoint>& points) {
  return std::is_sorted(points.begin(), points.end(),
                        [](const ControlPoint& a, const ControlPoint& b) { return a.value < b.value; });
}

} // namespace

bool weasisNumber(JsonFields& fields, const std::string& key, double& target) {
  if (!fields.has(key) || fields.child(key).is_null())
    return false;
  if (!fields.child(key).is_string())
    return fields.number(key, target);
  const std::optional<double> number = numberIn(trimmed(fields.child(key).get_ref<const std::string&>()));
  if (!number)
    fields.fail(key, Message::tr("must be a number"));
  if (!std::isfinite(*number))
    fields.fail(key, Message::tr("must be a finite number"));
  target = *number;
  return true;
}

bool weasisFlag(JsonFields& fields, const std::string& key, bool absent) {
  if (!fields.has(key))
    return absent;
  const nlohmann::json& value = fields.child(key);
  return value == true || (value.is_string() && lowerCase(value.get<std::string>()) == "true");
}

void WeasisPoints::addLight(JsonFields& fields, double pointOpacity) {
  glm::dvec3 light = usualLight;
  const bool hasAmbient = weasisNumber(fields, "ambient", light.x);
  const bool hasDiffuse = weasisNumber(fields, "diffuse", light.y);
  if (weasisNumber(fields, "specular", light.z) || hasAmbient || hasDiffuse)
    lights.emplace_back(light, pointOpacity);
}

HeadLight weasisLight(const WeasisPoints& points, std::vector<Message>& changes) {
  HeadLight light{true, usualLight.x, usualLight.y, usualLight.z, 10.0, Reflection::blinn};
  if (points.lights.empty())
    return light;
  glm::dvec3 mean = points.lights.front().first;
  const bool isOne = std::all_of(points.lights.begin(), points.lights.end(),
                                 [&](const auto& entry) { return entry.first == mean; });
  if (!isOne) {
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (const auto& [coefficients, opacity] : points.lights) {
      const double weight = std::max(opacity, 1e-6); // where all are transparent, the plain mean
      sum += weight * coefficients;
      weights += weight;
    }
    mean = sum / weights;
    tell(changes,
         Message::tr("Ambient, diffuse and specular light that differ from point to point became their mean, "
                     "weighted by opacity: %1, %2 and %3.")
             .arg(Message::rounded(mean.x, 3))
             .arg(Message::rounded(mean.y, 3))
             .arg(Message::rounded(mean.z, 3)));
  }
  light.ambient = mean.x;
  light.diffuse = mean.y;
  light.specular = mean.z;
  return light;
}

TransferFunction weasisFunction(WeasisPoints points, const std::string& file, std::vector<Message>& changes) {
  if (!ascend(points.opacity))
    tell(changes,
         Message::tr("Its points do not ascend in value and were sorted; Weasis would draw some of them "
                     "otherwise."));
  if (points.color.empty() && !points.opacity.empty()) {
    points.color.push_back({points.opacity.front().value, glm::dvec3(1.0), 0.0});
    tell(changes, Message::tr("None of its points has a colour; white was taken."));
  }
  const std::vector<ControlPoint> opacity = checkedCurve(std::move(points.opacity), file, changes);
  return merged(opacity, checkedCurve(std::move(points.color), file, changes));
}

} // namespace limn
