// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json/JsonFields.h"
#include "io/looks/Look.h"
#include "io/looks/curves/CurvedSegments.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/VtkProperty.h"
#include "io/looks/text/LookText.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

// Weasis' presets: a list of looks of groups of points, whose numbers and flags are texts. A point may have
// no colour, which then lies between those of its neighbours, and has a light of its own.
// Weasis' colour maps, which took the place of its presets in 2026 (schema 1): stops with a colour, an
// opacity or both, each a curve of its own; without a colour white, without an opacity opaque. Numbers may be
// texts.

namespace limn {
namespace {

// The points of a look of Weasis: those with an opacity, those with a colour, and the light of those that
// have one.
struct WeasisPoints {
  std::vector<ControlPoint> opacity;
  std::vector<ControlPoint> color;
  std::vector<std::pair<glm::dvec3, double>> lights; ///< ambient, diffuse and specular; opacity of the point

  /// Adds the light that the fields of a point say, if any.
  void addLight(JsonFields& fields, double pointOpacity);
};

const glm::dvec3 usualLight(0.2, 0.9, 0.2); // what Weasis takes for ambient, diffuse and specular if absent

bool ascend(const std::vector<ControlPoint>& points) {
  return std::is_sorted(points.begin(), points.end(),
                        [](const ControlPoint& a, const ControlPoint& b) { return a.value < b.value; });
}

// A number of Weasis, which may be a text; false where it is absent or null. Throws Error (input) where it
// is no finite number.
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

// A flag, which may be a text.
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

// One light for all points: theirs where they agree, otherwise their mean, weighted by opacity, which is
// told. Without any, what Weasis takes then.
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
             .arg(Message::rounded(mean.x, 3), Message::rounded(mean.y, 3), Message::rounded(mean.z, 3)));
  }
  light.ambient = mean.x;
  light.diffuse = mean.y;
  light.specular = mean.z;
  return light;
}

// The function of the points, checked and sorted, which is told where it changes something.
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
             : Message::tr("Its colour space \"%1\" became %2.").arg(plainText(space, 40), "RGB"));
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
  const HeadLight light = headLightOf(preset.shading, Reflection::blinn, written.changes);
  TransferFunction function = overOneMillimetre(preset.transferFunction, written.changes);
  if (function.points.empty())
    function.points = {{}}; // as transparent
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

LookFormat weasisMapsFormat() {
  return {Message::tr("Weasis colour maps"), {}, isWeasisMaps, readWeasisMaps, nullptr};
}

LookFormat weasisJsonFormat() {
  return {Message::tr("Weasis presets"), {".weasis.json"}, isWeasisJson, readWeasisJson, writeWeasisJson};
}

} // namespace limn
