// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json/JsonFields.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/text/LookText.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace limn {
namespace {

// A colour map as MRIcroGL and niivue keep it: nodes at 0..255 of a range of values, colours in bytes.
struct ByteNodes {
  struct Node {
    double intensity = 0.0;       ///< 0..255
    std::array<double, 4> rgba{}; ///< 0..255 each
  };
  double low = 0.0;  ///< the value of intensity 0
  double high = 0.0; ///< of 255; both the same: of the volume's own range
  std::vector<Node> nodes;
};

constexpr double levels = 255.0;

ByteNodes::Node nodeOf(const ControlPoint& point, const ByteNodes& map) {
  const double fraction = (point.value - map.low) / (map.high - map.low);
  return {std::round(levels * fraction),
          {std::round(levels * point.color.r), std::round(levels * point.color.g),
           std::round(levels * point.color.b), std::round(levels * point.opacity)}};
}

double valueOf(const ByteNodes::Node& node, const ByteNodes& map) {
  return map.low + node.intensity / levels * (map.high - map.low);
}

// A range that the points span, or where they all lie at one value, some that begins there.
void setRange(ByteNodes& map, const std::vector<ControlPoint>& points) {
  map.low = points.front().value;
  map.high = points.back().value;
  if (map.low == map.high)
    map.high += std::max(1.0, std::abs(map.low) * 1e-6);
}

void tellRounding(const TransferFunction& function, const ByteNodes& map, std::vector<Message>& changes) {
  double moved = 0.0, shade = 0.0;
  for (const ControlPoint& point : function.points) {
    const ByteNodes::Node node = nodeOf(point, map);
    moved = std::max(moved, std::abs(valueOf(node, map) - point.value));
    const std::array<double, 4> exact{point.color.r, point.color.g, point.color.b, point.opacity};
    for (std::size_t channel = 0; channel < 4; ++channel)
      shade = std::max(shade, std::abs(node.rgba[channel] / levels - exact[channel]));
  }
  if (moved > 1e-9 * (map.high - map.low))
    changes.push_back(
        Message::tr("The format has 256 places for points: the values of some moved, by up to %1.")
            .arg(Message::rounded(moved, 3)));
  if (shade > 1e-9)
    changes.push_back(
        Message::tr("The format has colours and opacities in 256 levels: some were rounded, by up to %1.")
            .arg(Message::rounded(shade, 3)));
}

// The points of a map: value = low + intensity/255 (high - low). Throws Error (input), naming `file`, where
// the range is upside down or an intensity lies outside 0..255.
PointLook pointLook(const ByteNodes& map, const std::string& file) {
  if (map.low > map.high)
    failReading(file, Message::tr("its range of values ends before it begins"), saveLookAgain);
  PointLook look;
  look.isRelative = map.low == map.high;
  for (const ByteNodes::Node& node : map.nodes) {
    if (node.intensity < 0.0 || node.intensity > levels)
      failReading(file, Message::tr("the intensity of one of its points is not in 0..255"), saveLookAgain);
    const double value = look.isRelative ? node.intensity / levels : valueOf(node, map);
    look.points.push_back(
        {value, glm::dvec3(node.rgba[0], node.rgba[1], node.rgba[2]) / levels, node.rgba[3] / levels});
  }
  return look;
}

// The map nearest to a function, which has points: over the range of its points, everything rounded to whole
// numbers. Says in `changes` what that changed.
ByteNodes byteNodes(const TransferFunction& function, std::vector<Message>& changes) {
  const std::vector<ControlPoint>& points = function.points;
  ByteNodes map;
  setRange(map, points);
  std::size_t dropped = 0;
  for (const ControlPoint& point : points) {
    const ByteNodes::Node node = nodeOf(point, map);
    const std::size_t count = map.nodes.size();
    // Of several at one place only the first and the last are seen.
    if (count >= 2 && map.nodes[count - 2].intensity == node.intensity) {
      map.nodes.pop_back();
      ++dropped;
    }
    map.nodes.push_back(node);
  }
  if (map.nodes.back().intensity < levels)
    map.nodes.push_back({levels, map.nodes.back().rgba});
  tellRounding(function, map, changes);
  if (dropped > 0)
    changes.push_back(Message::tr("%1 points lie closer together than the format can tell and were left out.")
                          .arg(dropped));
  return map;
}

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

/// The entries of a file of sections, by their names in lower case, which no two sections share.
using Entries = std::map<std::string, std::string, std::less<>>;

bool isMricroglClut(std::string_view text) {
  return lowerCase(text.substr(0, 4096)).find("numnodes") != std::string::npos &&
         text.find('[') < text.size() && text.find('{') == std::string_view::npos;
}

Entries entriesOf(std::string_view text) {
  Entries entries;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos && !line.starts_with(';'))
      entries.emplace(lowerCase(trimmed(line.substr(0, equals))), trimmed(line.substr(equals + 1)));
  }
  return entries;
}

double clutNumber(const std::string& file, std::string_view text) {
  const std::optional<double> number = numberIn(trimmed(text));
  if (!number)
    failReading(file,
                Message::tr("it has \"%1\" where a number is needed").arg(std::string(text.substr(0, 40))),
                saveLookAgain);
  return *number;
}

double clutNumberOr(const Entries& entries, std::string_view name, double otherwise,
                    const std::string& file) {
  const auto found = entries.find(name);
  return found == entries.end() ? otherwise : clutNumber(file, found->second);
}

std::string_view entry(const Entries& entries, const std::string& name, const std::string& file) {
  const auto found = entries.find(name);
  if (found == entries.end())
    failReading(file, Message::tr("its entry \"%1\" is missing").arg(name), saveLookAgain);
  return found->second;
}

std::array<double, 4> rgbaOf(const std::string& file, std::string_view text) {
  std::array<double, 4> rgba{};
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const std::size_t end = text.find('|');
    if ((end == std::string_view::npos) != (channel == 3))
      failReading(file, Message::tr("a colour has another number of parts than four"), saveLookAgain);
    rgba[channel] = clutNumber(file, text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return rgba;
}

std::vector<ReadLook> readMricroglClut(std::string_view text, const std::string& file,
                                       const std::optional<LookTarget>& target) {
  const Entries entries = entriesOf(text);
  const double count = clutNumber(file, entry(entries, "numnodes", file));
  if (!(count >= 1.0 && count <= static_cast<double>(entries.size())))
    failReading(file, Message::tr("it has fewer points than it says"), saveLookAgain);
  ByteNodes map;
  map.low = clutNumberOr(entries, "min", 0.0, file);
  map.high = clutNumberOr(entries, "max", 0.0, file);
  const auto nodes = static_cast<std::size_t>(count);
  for (std::size_t i = 0; i < nodes; ++i) {
    const std::string number = std::to_string(i);
    map.nodes.push_back({clutNumber(file, entry(entries, "nodeintensity" + number, file)),
                         rgbaOf(file, entry(entries, "nodergba" + number, file))});
  }
  PointLook look = pointLook(map, file);
  if (entries.contains("nodergba" + std::to_string(nodes)))
    look.changes.push_back(
        Message::tr("It has more points than the %1 that it counts; those behind them were left out.")
            .arg(nodes));
  return finished(std::move(look), file, target);
}

WrittenLook writeMricroglClut(const Preset& preset, const std::optional<LookTarget>&) {
  WrittenLook written;
  const ByteNodes map = byteNodes(pointsAlone(preset, written.changes), written.changes);
  std::string intensities, colors;
  for (std::size_t i = 0; i < map.nodes.size(); ++i) {
    const ByteNodes::Node& node = map.nodes[i];
    const std::string number = std::to_string(i);
    intensities += "nodeintensity" + number + "=" + shortest(node.intensity) + "\n";
    colors += "nodergba" + number + "=" + shortest(node.rgba[0]) + "|" + shortest(node.rgba[1]) + "|" +
              shortest(node.rgba[2]) + "|" + shortest(node.rgba[3]) + "\n";
  }
  written.text = "[FLT]\nmin=" + shortest(map.low) + "\nmax=" + shortest(map.high) +
                 "\n[INT]\nnumnodes=" + std::to_string(map.nodes.size()) + "\n[BYT]\n" + intensities +
                 "[RGBA255]\n" + colors;
  return written;
}

} // namespace

LookFormat niivueMapFormat() {
  return {Message::tr("niivue colour map"), {".niivue.json"}, isNiivueMap, readNiivueMap, writeNiivueMap};
}

LookFormat mricroglClutFormat() {
  return {Message::tr("MRIcroGL colour map"), {".clut"}, isMricroglClut, readMricroglClut, writeMricroglClut};
}

} // namespace limn
