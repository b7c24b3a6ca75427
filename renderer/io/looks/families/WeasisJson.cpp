// SPDX-License-Identifier: GPL-3.0-or-later
// Weasis' presets: a list of looks of groups of points, whose numbers and flags are texts. A point may have
// no colour, which then lies between those of its neighbours, and has a light of its own.
#include "io/json/JsonFields.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/curves/LookUnits.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/VtkProperty.h"
#include "io/looks/families/WeasisPoints.h"
#include "io/looks/text/LookText.h"
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

void addPoint(WeasisPoints& points, JsonFields& fields) {
  ControlPoint point;
  if (!weasisNumber(fields, "intensity", point.value))
    fields.fail("intensity", Message::tr("is missing"));
  if (!weasisNumber(fields, "opacity", point.opacity))
    fields.fail("opacity", Message::tr("is missing"));
  points.opacity.push_back(point);
  points.addLight(fields, point.opacity);
  point.color = glm::dvec3(0.0);
  if (!weasisNumber(fields, "red", point.color.r))
    return;
  weasisNumber(fields, "green", point.color.g);
  weasisNumber(fields, "blue", point.color.b);
  points.color.push_back(point);
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
      addPoint(points, pointFields);
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
  HeadLight light = weasisLight(points, read.changes);
  light.isOn = weasisFlag(fields, "shade", false);
  weasisNumber(fields, "specularPower", light.exponent);
  preset.shading = shadingOf(light, read.changes);
  preset.transferFunction = weasisFunction(std::move(points), file, read.changes);
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
  double farthest = 0.0;
  for (const ControlPoint& point : points) {
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    const double whole = std::round(std::clamp(point.value, -most, most));
    farthest = std::max(farthest, std::abs(whole - point.value));
    list.push_back({{"intensity", std::to_string(static_cast<std::int32_t>(whole))},
                    {"opacity", shortest(point.opacity)},
                    {"red", shortest(point.color.r)},
                    {"green", shortest(point.color.g)},
                    {"blue", shortest(point.color.b)},
                    {"ambient", shortest(light.ambient)},
                    {"diffuse", shortest(light.diffuse)},
                    {"specular", shortest(light.specular)}});
  }
  if (farthest > 0.0)
    tell(changes, Message::tr("Values were rounded to whole ones, by up to %1: Weasis has no others.")
                      .arg(Message::rounded(farthest, 3)));
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
