// SPDX-License-Identifier: GPL-3.0-or-later
// Weasis' colour maps, which took the place of its presets in 2026 (schema 1): stops with a colour, an
// opacity or both, each a curve of its own; without a colour white, without an opacity opaque. Numbers may be
// texts.
#include "io/looks/curves/CurvedSegments.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/curves/LookUnits.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/VtkProperty.h"
#include "io/looks/families/WeasisPoints.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <nlohmann/json.hpp>

#include <charconv>

namespace limn {
namespace {

using nlohmann::json;

bool isWeasisMaps(std::string_view text) {
  const auto has = [&](std::string_view key) { return text.find(key) != std::string_view::npos; };
  return has("\"stops\"") && (has("\"pos\"") || has("\"maps\""));
}

// "#rgb", "#rrggbb" or "#rrggbbaa", of which the last two do not count.
glm::dvec3 colorOf(JsonFields& stop) {
  std::string text;
  stop.text("color", text);
  std::string digits = text.substr(text.starts_with('#') ? 1 : 0);
  if (digits.size() == 3)
    digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
  glm::dvec3 color(0.0);
  for (int channel = 0; channel < 3; ++channel) {
    const char* const start = digits.data() + 2 * channel;
    unsigned byte = 0;
    const bool isLong = digits.size() == 6 || digits.size() == 8;
    if (!isLong || std::from_chars(start, start + 2, byte, 16).ptr != start + 2)
      stop.fail("color", Message::tr("must be a colour such as #ff8000"));
    color[channel] = byte / 255.0;
  }
  return color;
}

WeasisPoints stopsIn(JsonFields& map) {
  if (!map.has("stops") || !map.child("stops").is_array())
    map.fail("stops", Message::tr("must be a list of points"));
  WeasisPoints points;
  for (const json& item : map.child("stops")) {
    JsonFields stop(item, map.document(), "stops");
    ControlPoint point{0.0, glm::dvec3(1.0), 1.0};
    if (!weasisNumber(stop, "pos", point.value))
      stop.fail("pos", Message::tr("is missing"));
    const bool hasOpacity = weasisNumber(stop, "alpha", point.opacity);
    if (stop.has("color") && !stop.child("color").is_null()) {
      point.color = colorOf(stop);
      points.color.push_back(point);
    }
    if (hasOpacity)
      points.opacity.push_back(point);
    points.addLight(stop, point.opacity);
  }
  if (points.opacity.empty() && !points.color.empty())
    points.opacity.push_back({points.color.front().value, glm::dvec3(1.0), 1.0});
  return points;
}

std::string wordIn(JsonFields& fields, const std::string& key, const std::string& absent) {
  std::string word = absent;
  fields.text(key, word);
  return lowerCase(word);
}

// Each point holds up to the next.
std::vector<ControlPoint> held(std::vector<ControlPoint> points, const std::string& file,
                               std::vector<Message>& changes) {
  points = checkedCurve(std::move(points), file, changes);
  std::vector<ControlPoint> steps;
  for (const ControlPoint& point : points) {
    if (!steps.empty()) {
      steps.push_back(steps.back());
      steps.back().value = point.value;
    }
    steps.push_back(point);
  }
  return steps;
}

std::vector<ControlPoint> inSpace(std::vector<ControlPoint> points, const std::string& space,
                                  const std::string& file, std::vector<Message>& changes) {
  if (space == "rgb")
    return points;
  const bool isLab = space == "lab";
  tell(changes,
       isLab ? Message::tr("Colours between points in the colour space %1 became points in RGB.").arg("Lab")
             : Message::tr("Its colour space \"%1\" became %2.").arg(plainText(space, 40)).arg("RGB"));
  if (!isLab)
    return points;
  std::vector<BentPoint> bent;
  bent.reserve(points.size());
  for (const ControlPoint& point : points)
    bent.push_back({point});
  return straightened(checkedCurve(std::move(bent), file, changes), {ColorSpace::lab}, file, changes);
}

TransferFunction mapFunction(JsonFields& map, WeasisPoints points, const std::string& file,
                             std::vector<Message>& changes) {
  const std::string interpolation = wordIn(map, "interpolation", "linear");
  if (interpolation == "step") {
    points.opacity = held(std::move(points.opacity), file, changes);
    points.color = held(std::move(points.color), file, changes);
  } else {
    if (interpolation == "spline")
      tell(changes, Message::tr("Its interpolation \"%1\" became linear.").arg(interpolation));
    points.color = inSpace(std::move(points.color), wordIn(map, "space", "rgb"), file, changes);
  }
  return weasisFunction(std::move(points), file, changes);
}

// Where the values of a map lie.
TransferFunction placed(JsonFields& map, TransferFunction function, const std::optional<LookTarget>& target,
                        std::vector<Message>& changes) {
  std::string kind = "relative";
  if (map.has("domain")) {
    JsonFields domain = map.object("domain");
    kind = wordIn(domain, "kind", kind);
  }
  if (kind == "absolute" || kind == "fixed")
    return function;
  if (kind == "percent") {
    for (ControlPoint& point : function.points)
      point.value /= 100.0;
    tell(changes, Message::tr("Its values in percent were taken of the range of values."));
  }
  return stretchedOver(function, target, changes);
}

void addMapLight(JsonFields& map, const WeasisPoints& points, ReadLook& read) {
  if (!map.has("lighting"))
    return;
  JsonFields lighting = map.object("lighting");
  HeadLight light = weasisLight(points, read.changes);
  light.isOn = weasisFlag(lighting, "shade", false);
  weasisNumber(lighting, "specularPower", light.exponent);
  read.preset.shading = shadingOf(light, read.changes);
  if (lighting.has("gradientOpacity"))
    tell(read.changes,
         Message::tr("Its gradient opacity was left out: it follows another measure of the gradient."));
}

ReadLook mapLook(const json& item, const std::string& file, std::size_t index,
                 const std::optional<LookTarget>& target) {
  JsonFields map(item, file, "maps[" + std::to_string(index) + "]");
  ReadLook read;
  map.text("name", read.preset.name);
  read.preset.name = read.preset.name.empty() ? lookNameOf(file, index) : plainText(read.preset.name, 200);
  if (map.has("modality") && map.child("modality").is_array() && map.child("modality").size() == 1 &&
      map.child("modality").front().is_string())
    read.preset.modality = plainText(map.child("modality").front().get<std::string>(), 40);
  const WeasisPoints points = stopsIn(map);
  read.preset.transferFunction =
      placed(map, mapFunction(map, points, file, read.changes), target, read.changes);
  addMapLight(map, points, read);
  if (map.has("outside"))
    tell(read.changes,
         Message::tr("Its colours beyond its ends were left out: the curve goes on with its last ones."));
  tell(read.changes, oneMillimetreTaken);
  return read;
}

std::vector<ReadLook> readWeasisMaps(std::string_view text, const std::string& name,
                                     const std::optional<LookTarget>& target) {
  const json document = parsedJson(text, name);
  const bool isEnvelope = document.is_object() && document.contains("maps");
  const json& maps = isEnvelope ? document.at("maps") : document;
  std::vector<ReadLook> looks;
  if (maps.is_array())
    for (const json& item : maps)
      looks.push_back(mapLook(item, name, looks.size(), target));
  else
    looks.push_back(mapLook(maps, name, 0, target));
  if (looks.empty())
    failReading(name, Message::tr("it holds no colour map"), saveLookAgain);
  return looks;
}

} // namespace

LookFormat weasisMapsFormat() {
  return {Message::tr("Weasis colour maps"), {}, isWeasisMaps, readWeasisMaps, nullptr};
}

} // namespace limn
