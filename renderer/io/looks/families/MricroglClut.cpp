// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/ByteNodes.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/text/LookText.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <map>

namespace limn {
namespace {

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

LookFormat mricroglClutFormat() {
  return {Message::tr("MRIcroGL colour map"), {".clut"}, isMricroglClut, readMricroglClut, writeMricroglClut};
}

} // namespace limn
