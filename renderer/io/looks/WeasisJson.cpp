// SPDX-License-Identifier: GPL-3.0-or-later
// Weasis' presets: a list of looks of groups of points, whose numbers and flags are texts. A point may have
// no colour, which then lies between those of its neighbours, and has a light of its own.
#include "io/json/JsonFields.h"
#include "io/looks/Families.h"
#include "io/looks/LookCurves.h"
#include "io/looks/LookLight.h"
#include "io/looks/LookText.h"
#include "io/looks/LookUnits.h"
#include "io/looks/VtkProperty.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace limn {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* everyModality = "ALL";

bool isWeasisJson(std::string_view text) {
  return text.find("\"intensity\"") != std::string_view::npos &&
         text.find("\"opacity\"") != std::string_view::npos &&
         text.find("\"group\"") != std::string_view::npos;
}

// A number, which may be a text. False where it is absent.
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
  const json& value = fields.child(key);
  return value == true || (value.is_string() && lowerCase(value.get<std::string>()) == "true");
}

/// Gathers the points of a look.
struct WeasisPoints {
  std::vector<ControlPoint> opacity;
  std::vector<ControlPoint> color;
  // Sums over points with a light, weighted by opacity and not.
  std::vector<std::pair<glm::dvec3, double>> lights; // ambient, diffuse, specular; opacity

  void add(JsonFields& fields) {
    ControlPoint point;
    if (!weasisNumber(fields, "intensity", point.value))
      fields.fail("intensity", Message::tr("is missing"));
    if (!weasisNumber(fields, "opacity", point.opacity))
      fields.fail("opacity", Message::tr("is missing"));
    opacity.push_back(point);
    point.color = glm::dvec3(0.0);
    if (weasisNumber(fields, "red", point.color.r)) {
      weasisNumber(fields, "green", point.color.g);
      weasisNumber(fields, "blue", point.color.b);
      color.push_back(point);
    }
    glm::dvec3 light(0.2, 0.9, 0.2); // what Weasis takes for those that are absent
    const bool hasAmbient = weasisNumber(fields, "ambient", light.x);
    const bool hasDiffuse = weasisNumber(fields, "diffuse", light.y);
    if (weasisNumber(fields, "specular", light.z) || hasAmbient || hasDiffuse)
      lights.emplace_back(light, point.opacity);
  }
};

// One light for all points: theirs where they agree, otherwise the mean by opacity.
HeadLight lightOf(const WeasisPoints& points, std::vector<Message>& changes) {
  HeadLight light{true, 0.2, 0.9, 0.2, 10.0, Reflection::blinn};
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

WeasisPoints pointsIn(JsonFields& fields) {
  if (!fields.has("group") || !fields.child("group").is_array())
    fields.fail("group", Message::tr("must be a list of groups of points"));
  WeasisPoints points;
  for (const json& item : fields.child("group")) {
    JsonFields group(item, fields.document(), "group");
    if (!group.has("point") || !group.child("point").is_array())
      group.fail("point", Message::tr("must be a list of points"));
    for (const json& point : group.child("point")) {
      JsonFields pointFields(point, fields.document(), "point");
      points.add(pointFields);
    }
  }
  return points;
}

ReadLook weasisLook(const json& item, const std::string& file, std::size_t index) {
  JsonFields fields(item, file, "[" + std::to_string(index) + "]");
  ReadLook read;
  Preset& preset = read.preset;
  fields.text("name", preset.name);
  fields.text("modality", preset.modality);
  preset.name = preset.name.empty() ? lookNameOf(file, index) : plainText(preset.name, 200);
  preset.modality = preset.modality == everyModality ? "" : plainText(preset.modality, 40);
  WeasisPoints points = pointsIn(fields);
  if (!std::is_sorted(points.opacity.begin(), points.opacity.end(),
                      [](const ControlPoint& a, const ControlPoint& b) { return a.value < b.value; }))
    tell(read.changes,
         Message::tr("Its points do not ascend in value and were sorted; Weasis would draw some of them "
                     "otherwise."));
  if (points.color.empty() && !points.opacity.empty()) {
    points.color.push_back(points.opacity.front());
    tell(read.changes, Message::tr("None of its points has a colour; white was taken."));
  }
  HeadLight light = lightOf(points, read.changes);
  light.isOn = weasisFlag(fields, "shade", false);
  weasisNumber(fields, "specularPower", light.exponent);
  preset.shading = shadingOf(light, read.changes);
  const std::vector<ControlPoint> opacity = checkedCurve(std::move(points.opacity), file, read.changes);
  preset.transferFunction = merged(opacity, checkedCurve(std::move(points.color), file, read.changes));
  tell(read.changes, oneMillimetreTaken);
  return read;
}

std::vector<ReadLook> readWeasisJson(std::string_view text, const std::string& name,
                                     const std::optional<LookTarget>&) {
  json document = parsedJson(text, name);
  if (!document.is_array())
    document = json::array({std::move(document)});
  std::vector<ReadLook> looks;
  for (const json& item : document)
    looks.push_back(weasisLook(item, name, looks.size()));
  if (looks.empty())
    failReading(name, Message::tr("it holds no presets"), saveLookAgain);
  return looks;
}

ordered_json weasisPoints(const std::vector<ControlPoint>& points, const HeadLight& light,
                          std::vector<Message>& changes) {
  ordered_json list = ordered_json::array();
  for (const ControlPoint& point : points) {
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    const double whole = std::round(std::clamp(point.value, -most, most));
    if (whole != point.value)
      tell(changes, Message::tr("Values were rounded to whole ones: Weasis has no others."));
    list.push_back({{"intensity", std::to_string(static_cast<std::int32_t>(whole))},
                    {"opacity", shortest(point.opacity)},
                    {"red", shortest(point.color.r)},
                    {"green", shortest(point.color.g)},
                    {"blue", shortest(point.color.b)},
                    {"ambient", shortest(light.ambient)},
                    {"diffuse", shortest(light.diffuse)},
                    {"specular", shortest(light.specular)}});
  }
  return list;
}

WrittenLook writeWeasisJson(const Preset& preset, const std::optional<LookTarget>&) {
  WrittenLook written;
  TransferFunction function = overOneMillimetre(preset.transferFunction, written.changes);
  if (function.points.empty())
    function.points = {{}}; // as transparent
  const HeadLight light = headLightOf(preset.shading, Reflection::blinn, written.changes);
  if (preset.gradientOpacity)
    tell(written.changes, Message::tr("Its gradient opacity was left out: Weasis has none."));
  tellLostParts(preset, written.changes);
  const ordered_json group{{"name", "Default"},
                           {"point", weasisPoints(function.points, light, written.changes)}};
  const ordered_json look{{"name", preset.name},
                          {"modality", preset.modality.empty() ? everyModality : preset.modality},
                          {"shade", light.isOn ? "true" : "false"},
                          {"specularPower", shortest(light.exponent)},
                          {"group", ordered_json::array({group})}};
  written.text = textOf(ordered_json::array({look}));
  return written;
}

} // namespace

LookFormat weasisJsonFormat() {
  return {Message::tr("Weasis presets"), {".weasis.json"}, isWeasisJson, readWeasisJson, writeWeasisJson};
}

} // namespace limn
