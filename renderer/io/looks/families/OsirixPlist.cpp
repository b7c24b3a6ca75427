// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/VtkProperty.h"
#include "io/looks/text/LookText.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// 3D presets of OsiriX, Horos and InVesalius: property lists in XML, with the same keys. A look is a list of
// curves over the value, each with a colour for each of its points; where no curve is, nothing is seen.

namespace limn {
namespace {

// A dictionary of an Apple property list in XML, asked by key, whatever the order. Keys that are absent give
// what is passed for that; `file` is how errors call it. Throws Error (input) where a value is of a wrong
// kind.
class PlistFields {
public:
  PlistFields(const pugi::xml_node& dict, const std::string& file) : m_dict(dict), m_file(file) {}

  pugi::xml_node value(const char* key) const;
  std::string text(const char* key) const;
  double number(const char* key, double absent) const;
  bool flag(const char* key, bool absent) const;
  /// The items of a list; none where it is absent.
  std::vector<pugi::xml_node> list(const char* key) const;
  /// A list of numbers.
  std::vector<double> numbers(const char* key) const;

private:
  double numberOf(const pugi::xml_node& value, const char* key) const;

  pugi::xml_node m_dict;
  const std::string& m_file;
};

pugi::xml_node PlistFields::value(const char* key) const {
  for (const pugi::xml_node& child : m_dict.children("key"))
    if (trimmed(child.text().get()) == key)
      for (pugi::xml_node next = child.next_sibling(); next; next = next.next_sibling())
        if (next.type() == pugi::node_element)
          return next;
  return {};
}

std::string PlistFields::text(const char* key) const {
  return value(key).text().get();
}

double PlistFields::number(const char* key, double absent) const {
  const pugi::xml_node found = value(key);
  return found ? numberOf(found, key) : absent;
}

double PlistFields::numberOf(const pugi::xml_node& found, const char* key) const {
  const std::optional<double> number = numberIn(trimmed(found.text().get()));
  const std::string_view kind = found.name();
  if (!number || !std::isfinite(*number) || (kind != "real" && kind != "integer" && kind != "string"))
    failReading(m_file, Message::tr("its \"%1\" is no finite number").arg(key), saveLookAgain);
  return *number;
}

bool PlistFields::flag(const char* key, bool absent) const {
  const pugi::xml_node found = value(key);
  const std::string_view kind = found.name();
  if (!found)
    return absent;
  if (kind == "true" || kind == "false")
    return kind == "true";
  return numberOf(found, key) != 0.0;
}

std::vector<pugi::xml_node> PlistFields::list(const char* key) const {
  const pugi::xml_node found = value(key);
  if (found && std::string_view(found.name()) != "array")
    failReading(m_file, Message::tr("its \"%1\" is no list").arg(key), saveLookAgain);
  std::vector<pugi::xml_node> items;
  for (const pugi::xml_node& item : found.children())
    if (item.type() == pugi::node_element)
      items.push_back(item);
  return items;
}

std::vector<double> PlistFields::numbers(const char* key) const {
  std::vector<double> result;
  for (const pugi::xml_node& item : list(key))
    result.push_back(numberOf(item, key));
  return result;
}

constexpr std::size_t tableLength = 256; // of an 8-bit colour table
constexpr double tableHighest = 255.0;
constexpr const char* linearTable = "Linear Table";

/// The lights that these programs have by name.
struct NamedLight {
  const char* name;
  double ambient, diffuse, specular, exponent;
};
constexpr std::array<NamedLight, 4> namedLights{{{"Default", 0.15, 0.9, 0.3, 15.0},
                                                 {"Glossy Vascular", 0.15, 0.28, 1.42, 50.0},
                                                 {"Glossy Bone", 0.15, 0.24, 1.17, 6.98},
                                                 {"Endoscopy", 0.12, 0.64, 0.73, 50.0}}};

bool isOsirixPlist(std::string_view text) {
  return text.starts_with("bplist00") || text.find("<plist") != std::string_view::npos;
}

HeadLight osirixLight(const PlistFields& fields, std::vector<Message>& changes) {
  const std::string name = fields.text("shading");
  const auto found = std::find_if(namedLights.begin(), namedLights.end(),
                                  [&](const NamedLight& light) { return name == light.name; });
  const NamedLight& light = found != namedLights.end() ? *found : namedLights.front();
  const bool isOn = fields.flag("useShading", false);
  if (isOn && found == namedLights.end() && !name.empty())
    tell(changes,
         Message::tr("The numbers of its light \"%1\" are not in the file; those of \"%2\" were taken.")
             .arg(plainText(name, 80), light.name));
  return {isOn, light.ambient, light.diffuse, light.specular, light.exponent, Reflection::phong};
}

std::vector<ControlPoint> osirixCurve(const pugi::xml_node& places, const pugi::xml_node& colors,
                                      const std::string& file, std::vector<Message>& changes) {
  std::vector<ControlPoint> points;
  pugi::xml_node color = colors.child("dict");
  for (const pugi::xml_node& place : places.children("dict")) {
    if (!color)
      break;
    const PlistFields at(place, file), shown(color, file);
    if (!at.value("x") || !at.value("y"))
      failReading(file, Message::tr("a point in it lacks its place"), saveLookAgain);
    points.push_back({at.number("x", 0.0),
                      {shown.number("red", 0.0), shown.number("green", 0.0), shown.number("blue", 0.0)},
                      at.number("y", 0.0)});
    color = color.next_sibling("dict");
  }
  const auto count = [](const pugi::xml_node& list) {
    return std::distance(list.children("dict").begin(), list.children("dict").end());
  };
  if (count(places) != count(colors))
    failReading(file,
                Message::tr("a curve in it has %1 points and %2 colours").arg(count(places), count(colors)),
                saveLookAgain);
  return checkedCurve(std::move(points), file, changes);
}

// The curves under the keys of OsiriX and InVesalius, or those of Horos' functions alone.
TransferFunction osirixCurves(const PlistFields& fields, const std::string& file,
                              std::vector<Message>& changes) {
  const bool isFunctionAlone = !fields.value("16bitClutCurves");
  const auto places = fields.list(isFunctionAlone ? "curves" : "16bitClutCurves");
  const auto colors = fields.list(isFunctionAlone ? "colors" : "16bitClutColors");
  if (places.size() != colors.size())
    failReading(file, Message::tr("it has %1 curves and colours for %2").arg(places.size(), colors.size()),
                saveLookAgain);
  if (places.empty())
    failReading(file, Message::tr("it has no curves"), saveLookAgain);
  if (places.size() > mostJoinedCurves)
    failReading(file, Message::tr("it has more than %1 curves").arg(mostJoinedCurves),
                Message::tr("save it with fewer curves"));
  std::vector<std::vector<ControlPoint>> curves;
  std::size_t points = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    curves.push_back(osirixCurve(places[i], colors[i], file, changes));
    requirePointCount(points += curves.back().size(), file);
  }
  bool overlap = false;
  TransferFunction function = naming(file, [&] { return normalised(joined(curves, &overlap)); });
  if (overlap)
    tell(changes, Message::tr("Curves that overlap became one; where they do, the most opaque shows."));
  return function;
}

std::vector<glm::dvec3> osirixTable(const PlistFields& fields, const std::string& file,
                                    std::vector<Message>& changes) {
  std::array<std::vector<double>, 3> channels{fields.numbers("Red"), fields.numbers("Green"),
                                              fields.numbers("Blue")};
  if (channels[0].empty() && channels[1].empty() && channels[2].empty()) {
    const std::string name = fields.text("CLUT");
    if (!name.empty() && name != "No CLUT")
      tell(changes, Message::tr("Its colour table \"%1\" is another file; greys took its place.")
                        .arg(plainText(name, 80)));
    return {glm::dvec3(0.0), glm::dvec3(1.0)};
  }
  std::vector<glm::dvec3> table;
  for (const std::vector<double>& channel : channels)
    if (channel.size() != tableLength)
      failReading(file,
                  Message::tr("a channel of its colour table has %1 entries instead of %2")
                      .arg(channel.size(), tableLength),
                  saveLookAgain);
  for (std::size_t i = 0; i < tableLength; ++i)
    table.push_back(glm::dvec3(channels[0][i], channels[1][i], channels[2][i]) / tableHighest);
  return table;
}

// A colour table over a window, with a ramp of opacity.
TransferFunction osirixWindow(const PlistFields& fields, const std::string& file,
                              const std::optional<LookTarget>& target, std::vector<Message>& changes) {
  const std::vector<glm::dvec3> table = osirixTable(fields, file, changes);
  const bool hasWindow = fields.value("ww") && fields.value("wl");
  const double width = fields.number("ww", 1.0), centre = fields.number("wl", 0.5);
  if (!(width > 0.0))
    failReading(file, Message::tr("the width of its window is not above 0"), saveLookAgain);
  const std::string opacity = fields.text("opacity");
  if (!opacity.empty() && opacity != linearTable)
    tell(changes, Message::tr("Its opacity table \"%1\" is not in the file; a linear one took its place.")
                      .arg(plainText(opacity, 80)));
  std::vector<ControlPoint> points;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(table.size() - 1);
    points.push_back({centre + (u - 0.5) * width, table[i], u});
  }
  const TransferFunction function{1.0, checkedCurve(std::move(points), file, changes)};
  return hasWindow ? function : stretchedOver(function, target, changes);
}

void tellLostFields(const PlistFields& fields, std::vector<Message>& changes) {
  if (fields.number("projection", 0.0) != 0.0)
    tell(changes, Message::tr("Its camera, which is not perspective, was left out: looks hold none."));
  if (!fields.list("convolutionFilters").empty())
    tell(changes, Message::tr("Its filters of the volume were left out."));
  for (const char* key :
       {"backgroundColorRedComponent", "backgroundColorGreenComponent", "backgroundColorBlueComponent"})
    if (fields.number(key, 0.0) != 0.0)
      tell(changes, Message::tr("Its background was left out: looks hold none."));
}

// A modality that a group is named for, such as "Bone CT".
std::string modalityOfGroup(const std::string& group) {
  for (const std::string& word : words(group))
    if (std::string modality = modalityIn(word); !modality.empty())
      return modality;
  return "";
}

ReadLook osirixLook(const pugi::xml_node& dict, const std::string& file, std::size_t index,
                    const std::optional<LookTarget>& target) {
  const PlistFields fields(dict, file);
  ReadLook read;
  Preset& preset = read.preset;
  const std::string name = fields.text("name");
  preset.name = name.empty() ? lookNameOf(file, index) : plainText(name, 200);
  preset.folder = plainText(fields.text("groupName"), 200);
  preset.modality = modalityOfGroup(preset.folder);
  const bool hasCurves = fields.value("16bitClutCurves") || fields.value("curves");
  const bool hasTable = fields.value("CLUT") || fields.value("Red");
  if (!hasCurves && !hasTable)
    failReading(file, Message::tr("it is a property list, but no look of OsiriX, Horos or InVesalius"),
                Message::tr("choose another file"));
  preset.transferFunction = fields.flag("advancedCLUT", hasCurves)
                                ? osirixCurves(fields, file, read.changes)
                                : osirixWindow(fields, file, target, read.changes);
  if (fields.value("useShading"))
    preset.shading = shadingOf(osirixLight(fields, read.changes), read.changes);
  if (fields.flag("MIP", false))
    preset.projection = Projection::mip;
  tellLostFields(fields, read.changes);
  tell(read.changes, oneMillimetreTaken);
  return read;
}

std::vector<ReadLook> readOsirixPlist(std::string_view text, const std::string& name,
                                      const std::optional<LookTarget>& target) {
  if (text.starts_with("bplist"))
    failReading(name, Message::tr("it is a property list that is not text"),
                Message::tr("make it text first, on a Mac with: plutil -convert xml1 FILE"));
  pugi::xml_document document;
  if (!document.load_buffer(text.data(), text.size()))
    failReading(name, Message::tr("it is damaged or cut off"), Message::tr("copy or save it again"));
  std::vector<ReadLook> looks;
  const pugi::xml_node root = document.child("plist");
  for (const pugi::xml_node& dict : root.children("dict"))
    looks.push_back(osirixLook(dict, name, looks.size(), target));
  for (const pugi::xml_node& dict : root.child("array").children("dict"))
    looks.push_back(osirixLook(dict, name, looks.size(), target));
  if (looks.empty())
    failReading(name, Message::tr("it is a property list without a look"),
                Message::tr("choose another file"));
  return looks;
}

/// Begins a property list; what is written stands in the dictionary returned.
pugi::xml_node beginPlist(pugi::xml_document& document) {
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  document.append_child(pugi::node_doctype)
      .set_value("plist PUBLIC \"-//Apple//DTD PLIST 1.0//EN\" "
                 "\"http://www.apple.com/DTDs/PropertyList-1.0.dtd\"");
  pugi::xml_node plist = document.append_child("plist");
  plist.append_attribute("version") = "1.0";
  return plist.append_child("dict");
}

pugi::xml_node addItem(pugi::xml_node dict, const char* key, const char* kind,
                       const std::string& value = "") {
  dict.append_child("key").text() = key;
  pugi::xml_node item = dict.append_child(kind);
  if (!value.empty())
    item.text() = value.c_str();
  return item;
}

// Outside a curve nothing is seen there: what Limn shows beyond its ends is drawn out over 16 bits of values.
std::vector<ControlPoint> drawnOut(const TransferFunction& function) {
  constexpr double lowest = -32768.0, highest = 32767.0;
  std::vector<ControlPoint> points = function.points;
  if (points.front().opacity > 0.0 && points.front().value > lowest)
    points.insert(points.begin(), {lowest, points.front().color, points.front().opacity});
  if (points.back().opacity > 0.0 && points.back().value < highest)
    points.push_back({highest, points.back().color, points.back().opacity});
  return points;
}

void addOsirixCurve(pugi::xml_node root, const std::vector<ControlPoint>& points) {
  pugi::xml_node places = addItem(root, "16bitClutCurves", "array").append_child("array");
  pugi::xml_node colors = addItem(root, "16bitClutColors", "array").append_child("array");
  for (const ControlPoint& point : points) {
    pugi::xml_node place = places.append_child("dict"), color = colors.append_child("dict");
    addItem(place, "x", "real", shortest(point.value));
    addItem(place, "y", "real", shortest(point.opacity));
    addItem(color, "red", "real", shortest(point.color.r));
    addItem(color, "green", "real", shortest(point.color.g));
    addItem(color, "blue", "real", shortest(point.color.b));
  }
}

// The named light that is nearest, told where it is another.
const NamedLight& nearestLight(const HeadLight& light, std::vector<Message>& changes) {
  const auto distance = [&](const NamedLight& named) {
    return std::abs(named.ambient - light.ambient) + std::abs(named.diffuse - light.diffuse) +
           std::abs(named.specular - light.specular) +
           0.2 * std::abs(std::log2(named.exponent / std::max(light.exponent, 0.01)));
  };
  const NamedLight& nearest =
      *std::min_element(namedLights.begin(), namedLights.end(),
                        [&](const NamedLight& a, const NamedLight& b) { return distance(a) < distance(b); });
  if (light.isOn && distance(nearest) > 1e-9)
    tell(changes,
         Message::tr("Its light became \"%1\", the nearest that such files can name.").arg(nearest.name));
  return nearest;
}

WrittenLook writeOsirixPlist(const Preset& preset, const std::optional<LookTarget>&) {
  WrittenLook written;
  const HeadLight light = headLightOf(preset.shading, Reflection::phong, written.changes);
  TransferFunction function = overOneMillimetre(preset.transferFunction, written.changes);
  if (function.points.empty())
    function.points = {{}}; // as transparent
  const std::vector<ControlPoint> points = drawnOut(function);
  if (preset.gradientOpacity)
    tell(written.changes, Message::tr("Its gradient opacity was left out: such files have none."));
  const bool isMip = preset.projection == Projection::mip;
  Preset rest = preset;
  if (isMip) // which such files hold
    rest.projection.reset();
  tellLostParts(rest, written.changes);
  pugi::xml_document document;
  const pugi::xml_node root = beginPlist(document);
  const double low = points.front().value, high = points.back().value;
  const auto add = [&](const char* key, const char* kind, const std::string& value = "") {
    addItem(root, key, kind, value);
  };
  add("name", "string", preset.name);
  add("groupName", "string", preset.folder.empty() ? preset.modality : preset.folder);
  add("advancedCLUT", "true");
  add("CLUT", "string", "16-bit CLUT");
  addOsirixCurve(root, points);
  add("wl", "real", shortest(low / 2.0 + high / 2.0));
  add("ww", "real", shortest(high - low));
  add("useShading", light.isOn ? "true" : "false");
  add("shading", "string", nearestLight(light, written.changes).name);
  add("opacity", "string", linearTable);
  add("projection", "integer", "0");
  add("convolutionFilters", "array");
  for (const char* key :
       {"backgroundColorRedComponent", "backgroundColorGreenComponent", "backgroundColorBlueComponent"})
    add(key, "real", "0");
  if (isMip)
    add("MIP", "true");
  written.text = xmlText(document);
  return written;
}

} // namespace

LookFormat osirixPlistFormat() {
  return {Message::tr("OsiriX, Horos or InVesalius 3D preset"),
          {".plist"},
          isOsirixPlist,
          readOsirixPlist,
          writeOsirixPlist};
}

} // namespace limn
