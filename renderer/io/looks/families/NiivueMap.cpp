// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json/JsonFields.h"
#include "io/looks/curves/ByteNodes.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/reading/ReadError.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

bool isNiivueMap(std::string_view text) {
  const auto has = [&](std::string_view key) { return text.find(key) != std::string_view::npos; };
  return has("{") && has("\"R\"") && has("\"G\"") && has("\"B\"") && has("\"I\"");
}

double niivueNumber(const nlohmann::json& value, const std::string& file) {
  if (!value.is_number())
    failReading(file, Message::tr("it has something else where a number is needed"), saveLookAgain);
  return value.get<double>();
}

double niivueNumberOr(const nlohmann::json& map, const char* key, double otherwise, const std::string& file) {
  const auto found = map.find(key);
  return found == map.end() || found->is_null() ? otherwise : niivueNumber(*found, file);
}

std::vector<double> channel(const nlohmann::json& map, const char* key, const std::string& file) {
  const auto found = map.find(key);
  if (found == map.end() || !found->is_array())
    failReading(file, Message::tr("its list \"%1\" is missing").arg(key), saveLookAgain);
  std::vector<double> values;
  for (const nlohmann::json& value : *found)
    values.push_back(niivueNumber(value, file));
  return values;
}

std::vector<ReadLook> readNiivueMap(std::string_view text, const std::string& file,
                                    const std::optional<LookTarget>& target) {
  const nlohmann::json json = parsedJson(text, file);
  if (!json.is_object())
    failReading(file, Message::tr("it is no colour map"), saveLookAgain);
  if (json.contains("labels"))
    failReading(file, Message::tr("it colours labels and not values"),
                Message::tr("open a colour map of values instead"));
  std::array<std::vector<double>, 4> rgba;
  constexpr std::array<const char*, 4> keys{"R", "G", "B", "A"};
  const std::vector<double> intensities = channel(json, "I", file);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    rgba[i] = channel(json, keys[i], file);
    if (rgba[i].size() != intensities.size())
      failReading(file, Message::tr("its lists of colours have different lengths"), saveLookAgain);
  }
  ByteNodes map;
  map.low = niivueNumberOr(json, "min", 0.0, file);
  map.high = niivueNumberOr(json, "max", 0.0, file);
  for (std::size_t i = 0; i < intensities.size(); ++i)
    map.nodes.push_back({intensities[i], {rgba[0][i], rgba[1][i], rgba[2][i], rgba[3][i]}});
  return finished(pointLook(map, file), file, target);
}

WrittenLook writeNiivueMap(const Preset& preset, const std::optional<LookTarget>&) {
  WrittenLook written;
  const ByteNodes map = byteNodes(pointsAlone(preset, written.changes), written.changes);
  nlohmann::ordered_json json{{"min", map.low}, {"max", map.high}};
  constexpr std::array<const char*, 4> keys{"R", "G", "B", "A"};
  for (std::size_t i = 0; i < keys.size(); ++i)
    for (const ByteNodes::Node& node : map.nodes)
      json[keys[i]].push_back(static_cast<int>(node.rgba[i]));
  for (const ByteNodes::Node& node : map.nodes)
    json["I"].push_back(static_cast<int>(node.intensity));
  written.text = textOf(json);
  return written;
}

} // namespace

LookFormat niivueMapFormat() {
  return {Message::tr("niivue colour map"), {".niivue.json"}, isNiivueMap, readNiivueMap, writeNiivueMap};
}

} // namespace limn
