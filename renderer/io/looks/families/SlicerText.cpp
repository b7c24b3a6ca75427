// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json/JsonFields.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/VtkProperty.h"
#include "io/looks/text/LookText.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>

// 3D Slicer's volume properties before JSON: lines of text (.vp), and elements of a MRML scene or of its list
// of presets (.xml). Both write a function as how many numbers follow, and those.
// 3D Slicer's volume properties as JSON, its default since 5.4 (schema volume-property 1.0.0).
namespace limn {
namespace {

constexpr std::size_t opacityNumbers = 2; // of a point: value and opacity
constexpr std::size_t colorNumbers = 4;

/// Takes number by number from the words of a text.
class Numbers {
public:
  Numbers(std::string_view text, const std::string& file, std::vector<Message>& changes)
      : m_words(words(text)), m_file(file), m_changes(changes) {}

  std::size_t left() const { return m_words.size() - m_next; }

  double next() {
    const std::string& word = m_words[m_next++];
    std::size_t used = 0;
    const std::optional<double> number = leadingNumber(word, &used);
    // A second decimal point is known of Slicer's own presets; a decimal comma would be another number.
    if (!number || (used < word.size() && word[used] != '.'))
      failReading(m_file, Message::tr("it has \"%1\" where a number is needed").arg(word), saveLookAgain);
    if (used < word.size())
      tell(m_changes, Message::tr("The damaged number \"%1\" was read as %2, as other programs do.")
                          .arg(plainText(word, 40), Message::rounded(*number, 8)));
    return *number;
  }

private:
  std::vector<std::string> m_words;
  const std::string& m_file;
  std::vector<Message>& m_changes;
  std::size_t m_next = 0;
};

// A function's points, `perPoint` numbers each. None where the text is blank or says 0.
std::vector<BentPoint> slicerCurve(std::string_view text, std::size_t perPoint, const std::string& file,
                                   std::vector<Message>& changes) {
  Numbers numbers(text, file, changes);
  if (numbers.left() == 0)
    return {};
  const double count = numbers.next();
  if (count != static_cast<double>(numbers.left()) || numbers.left() % perPoint != 0)
    failReading(file,
                Message::tr("one of its functions should have %1 numbers, %2 for each point, and has %3")
                    .arg(Message::rounded(count, 8), perPoint, numbers.left()),
                Message::tr("copy or save it again"));
  requirePointCount(std::max<std::size_t>(1, numbers.left() / perPoint), file);
  std::vector<BentPoint> points;
  while (numbers.left() > 0) {
    BentPoint bent;
    bent.point.value = numbers.next();
    if (perPoint == opacityNumbers)
      bent.point.opacity = numbers.next();
    else
      for (int channel = 0; channel < 3; ++channel)
        bent.point.color[channel] = numbers.next();
    points.push_back(bent);
  }
  return points;
}

// The number in a text, or `absent` where it is blank.
double slicerNumber(std::string_view text, double absent, const std::string& file,
                    std::vector<Message>& changes) {
  Numbers numbers(text, file, changes);
  return numbers.left() > 0 ? numbers.next() : absent;
}

void tellInterpolation(double interpolation, std::vector<Message>& changes) {
  if (interpolation != 1.0)
    tell(changes, Message::tr("Its interpolation, which is not linear, became so."));
}

std::string curveText(const std::vector<BentPoint>& points, std::size_t perPoint) {
  std::string text = std::to_string(points.size() * perPoint);
  for (const BentPoint& bent : points) {
    text.append(" ").append(shortest(bent.point.value));
    if (perPoint == opacityNumbers)
      text.append(" ").append(shortest(bent.point.opacity));
    else
      for (int channel = 0; channel < 3; ++channel)
        text.append(" ").append(shortest(bent.point.color[channel]));
  }
  return text;
}

// --- lines of text ---

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(trimmed(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

// The lines of a .vp file.
enum SlicerLine {
  interpolationLine,
  shadeLine,
  diffuseLine,
  ambientLine,
  specularLine,
  powerLine,
  opacityLine,
  gradientLine,
  colorLine,
  slicerLines
};

// Six lines of a number at most, and none of several words before them.
bool isSlicerText(std::string_view text) {
  const std::vector<std::string_view> lines = linesOf(text.substr(0, std::size_t{1} << 12));
  if (lines.size() < 2 || trimmed(text).empty())
    return false;
  const std::size_t count = std::min<std::size_t>(lines.size(), opacityLine);
  return std::all_of(
      lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(count), [](std::string_view line) {
        return line.empty() || (leadingNumber(line) && line.find_first_of(" \t") == std::string_view::npos);
      });
}

std::vector<ReadLook> readSlicerText(std::string_view text, const std::string& name,
                                     const std::optional<LookTarget>& target) {
  const std::vector<std::string_view> lines = linesOf(text);
  if (lines.size() < slicerLines)
    failReading(name, Message::tr("it has %1 lines instead of %2").arg(lines.size(), int(slicerLines)),
                Message::tr("copy or save it again"));
  std::vector<Message> changes;
  const auto number = [&](SlicerLine line, double absent) {
    return slicerNumber(lines[line], absent, name, changes);
  };
  VtkProperty property;
  tellInterpolation(number(interpolationLine, 1.0), changes);
  property.light.isOn = number(shadeLine, 1.0) != 0.0;
  property.light.diffuse = number(diffuseLine, property.light.diffuse);
  property.light.ambient = number(ambientLine, property.light.ambient);
  property.light.specular = number(specularLine, property.light.specular);
  property.light.exponent = number(powerLine, property.light.exponent);
  property.opacity = slicerCurve(lines[opacityLine], opacityNumbers, name, changes);
  property.gradientOpacity = slicerCurve(lines[gradientLine], opacityNumbers, name, changes);
  property.color = slicerCurve(lines[colorLine], colorNumbers, name, changes);
  return {lookOf(std::move(property), name, 0, target, std::move(changes))};
}

WrittenLook writeSlicerText(const Preset& preset, const std::optional<LookTarget>& target) {
  WrittenLook written;
  const VtkProperty property = vtkPropertyOf(preset, false, target, written.changes);
  const HeadLight& light = property.light;
  written.text = "1\n";
  written.text += light.isOn ? "1\n" : "0\n";
  for (const double number : {light.diffuse, light.ambient, light.specular, light.exponent})
    written.text += shortest(number) + "\n";
  written.text += curveText(property.opacity, opacityNumbers) + "\n" +
                  curveText(property.gradientOpacity, opacityNumbers) + "\n" +
                  curveText(property.color, colorNumbers) + "\n";
  return written;
}

// --- elements ---

bool isMrml(std::string_view text) {
  return text.find("<VolumeProperty") != std::string_view::npos ||
         text.find("<MRML") != std::string_view::npos;
}

// Functions of an element that leaves its numbers to another file are blank.
bool holdsCurves(const pugi::xml_node& node) {
  return node.attribute("scalarOpacity") && node.attribute("colorTransfer");
}

class FoundProperties : public pugi::xml_tree_walker {
public:
  std::vector<pugi::xml_node> nodes;
  bool for_each(pugi::xml_node& node) override {
    if (std::string_view(node.name()) == "VolumeProperty" && holdsCurves(node))
      nodes.push_back(node);
    return true;
  }
};

VtkProperty propertyIn(const pugi::xml_node& node, const std::string& file, std::vector<Message>& changes) {
  const auto number = [&](const char* key, double absent) {
    return slicerNumber(node.attribute(key).value(), absent, file, changes);
  };
  VtkProperty property;
  property.name = node.attribute("name").value();
  tellInterpolation(number("interpolation", 1.0), changes);
  property.light.isOn = number("shade", 1.0) != 0.0;
  property.light.ambient = number("ambient", property.light.ambient);
  property.light.diffuse = number("diffuse", property.light.diffuse);
  property.light.specular = number("specular", property.light.specular);
  property.light.exponent = number("specularPower", property.light.exponent);
  property.opacity = slicerCurve(node.attribute("scalarOpacity").value(), opacityNumbers, file, changes);
  property.gradientOpacity =
      slicerCurve(node.attribute("gradientOpacity").value(), opacityNumbers, file, changes);
  property.color = slicerCurve(node.attribute("colorTransfer").value(), colorNumbers, file, changes);
  return property;
}

std::vector<ReadLook> readMrml(std::string_view text, const std::string& name,
                               const std::optional<LookTarget>& target) {
  pugi::xml_document document;
  if (!document.load_buffer(text.data(), text.size()))
    failReading(name, Message::tr("it is damaged or cut off"), Message::tr("copy or save it again"));
  FoundProperties found;
  document.traverse(found);
  if (found.nodes.empty())
    failReading(name, Message::tr("it has no volume property with functions of its own"),
                Message::tr("save the volume property itself from 3D Slicer"));
  std::vector<ReadLook> looks;
  for (const pugi::xml_node& node : found.nodes) {
    std::vector<Message> changes;
    VtkProperty property = propertyIn(node, name, changes);
    looks.push_back(lookOf(std::move(property), name, looks.size(), target, std::move(changes)));
  }
  return looks;
}

WrittenLook writeMrml(const Preset& preset, const std::optional<LookTarget>& target) {
  WrittenLook written;
  const VtkProperty property = vtkPropertyOf(preset, false, target, written.changes);
  pugi::xml_document document;
  pugi::xml_node node = document.append_child("MRML").append_child("VolumeProperty");
  const auto set = [&](const char* key, const std::string& value) {
    node.append_attribute(key) = value.c_str();
  };
  set("name", property.name);
  set("interpolation", "1");
  set("shade", property.light.isOn ? "1" : "0");
  set("ambient", shortest(property.light.ambient));
  set("diffuse", shortest(property.light.diffuse));
  set("specular", shortest(property.light.specular));
  set("specularPower", shortest(property.light.exponent));
  set("effectiveRange",
      shortest(property.opacity.front().point.value) + " " + shortest(property.opacity.back().point.value));
  set("scalarOpacity", curveText(property.opacity, opacityNumbers));
  set("gradientOpacity", curveText(property.gradientOpacity, opacityNumbers));
  set("colorTransfer", curveText(property.color, colorNumbers));
  written.text = xmlText(document);
  return written;
}

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* schema =
    "https://raw.githubusercontent.com/Slicer/Slicer/main/Modules/Loadable/VolumeRendering/Resources/Schema/"
    "volume-property-schema-v1.0.0.json#";
constexpr double noClippedIntensity = -1e10; // Slicer's default: air

bool isSlicerJson(std::string_view text) {
  return text.find("\"volumeProperties\"") != std::string_view::npos;
}

// The list under a key; an empty one where there is none.
const json& listIn(JsonFields& fields, const std::string& key) {
  static const json none = json::array();
  if (!fields.has(key))
    return none;
  if (!fields.child(key).is_array())
    fields.fail(key, Message::tr("must be a list"));
  return fields.child(key);
}

std::vector<BentPoint> curveIn(JsonFields& component, const std::string& key) {
  std::vector<BentPoint> points;
  if (!component.has(key))
    return points;
  JsonFields curve = component.object(key);
  for (const json& item : listIn(curve, "points")) {
    JsonFields fields(item, curve.document(), key + ".points");
    BentPoint bent;
    if (!fields.number("x", bent.point.value))
      fields.fail("x", Message::tr("is missing"));
    const bool hasOpacity = fields.number("y", bent.point.opacity);
    if (!fields.vector("color", bent.point.color) && !hasOpacity)
      fields.fail("y", Message::tr("is missing"));
    fields.number("midpoint", bent.midpoint);
    fields.number("sharpness", bent.sharpness);
    points.push_back(bent);
  }
  return points;
}

HeadLight lightIn(JsonFields& component) {
  HeadLight light;
  component.boolean("shade", light.isOn);
  if (!component.has("lighting"))
    return light;
  JsonFields fields = component.object("lighting");
  fields.number("ambient", light.ambient);
  fields.number("diffuse", light.diffuse);
  fields.number("specular", light.specular);
  fields.number("specularPower", light.exponent);
  return light;
}

VtkProperty componentIn(JsonFields& component) {
  VtkProperty property;
  property.opacity = curveIn(component, "scalarOpacity");
  property.color = curveIn(component, "rgbTransferFunction");
  property.gradientOpacity = curveIn(component, "gradientOpacity");
  component.boolean("disableGradientOpacity", property.gradientOpacityIsOff);
  property.light = lightIn(component);
  property.unitDistanceMm = 1.0; // VTK's default
  component.number("scalarOpacityUnitDistance", *property.unitDistanceMm);
  return property;
}

// What beside its first component Limn does not draw.
std::vector<Message> lostIn(JsonFields& property, JsonFields& component, std::size_t components) {
  std::vector<Message> lost;
  std::string interpolation = "linear";
  property.text("interpolationType", interpolation);
  if (interpolation != "linear")
    tell(lost, Message::tr("Its interpolation \"%1\" became linear.").arg(plainText(interpolation, 40)));
  if (components > 1)
    tell(lost, Message::tr("Of its %1 components only the first was taken.").arg(components));
  if (!listIn(property, "isoSurfaceValues").empty())
    tell(lost, Message::tr("Its isosurfaces were left out."));
  double anisotropy = 0.0;
  if (property.number("scatteringAnisotropy", anisotropy) && anisotropy != 0.0)
    tell(lost, Message::tr("Its scattering was left out."));
  bool usesClipped = true;
  double clipped = noClippedIntensity;
  property.boolean("useClippedVoxelIntensity", usesClipped);
  property.number("clippedVoxelIntensity", clipped);
  if (usesClipped && clipped != noClippedIntensity)
    tell(lost, Message::tr("The value that it gives clipped voxels was left out."));
  double weight = 1.0;
  if (component.number("componentWeight", weight) && weight != 1.0)
    tell(lost, Message::tr("The weight of its component was left out."));
  return lost;
}

std::vector<ReadLook> readSlicerJson(std::string_view text, const std::string& name,
                                     const std::optional<LookTarget>& target) {
  const json document = parsedJson(text, name);
  JsonFields fields(document, name, "");
  std::vector<ReadLook> looks;
  for (const json& item : listIn(fields, "volumeProperties")) {
    JsonFields property(item, name, "volumeProperties[" + std::to_string(looks.size()) + "]");
    const json& components = listIn(property, "components");
    if (components.empty())
      failReading(name, Message::tr("a volume property in it has no components"), saveLookAgain);
    JsonFields component(components.front(), name, "components[0]");
    std::vector<Message> lost = lostIn(property, component, components.size());
    looks.push_back(lookOf(componentIn(component), name, looks.size(), target, std::move(lost)));
  }
  if (looks.empty())
    failReading(name, Message::tr("it holds no volume property"), saveLookAgain);
  return looks;
}

ordered_json opacityJson(const std::vector<BentPoint>& curve) {
  ordered_json points = ordered_json::array();
  for (const BentPoint& bent : curve)
    points.push_back(
        {{"x", bent.point.value}, {"y", bent.point.opacity}, {"midpoint", 0.5}, {"sharpness", 0.0}});
  return {{"points", points}};
}

ordered_json colorJson(const std::vector<BentPoint>& curve) {
  ordered_json points = ordered_json::array();
  for (const BentPoint& bent : curve)
    points.push_back({{"x", bent.point.value},
                      {"color", {bent.point.color.r, bent.point.color.g, bent.point.color.b}},
                      {"midpoint", 0.5},
                      {"sharpness", 0.0}});
  return {{"points", points}};
}

WrittenLook writeSlicerJson(const Preset& preset, const std::optional<LookTarget>& target) {
  WrittenLook written;
  const VtkProperty property = vtkPropertyOf(preset, true, target, written.changes);
  const ordered_json component{{"componentWeight", 1.0},
                               {"shade", property.light.isOn},
                               {"lighting",
                                {{"ambient", property.light.ambient},
                                 {"diffuse", property.light.diffuse},
                                 {"specular", property.light.specular},
                                 {"specularPower", property.light.exponent}}},
                               {"disableGradientOpacity", !preset.gradientOpacity.has_value()},
                               {"scalarOpacityUnitDistance", *property.unitDistanceMm},
                               {"scalarOpacity", opacityJson(property.opacity)},
                               {"gradientOpacity", opacityJson(property.gradientOpacity)},
                               {"rgbTransferFunction", colorJson(property.color)}};
  const ordered_json whole{
      {"effectiveRange", {property.opacity.front().point.value, property.opacity.back().point.value}},
      {"isoSurfaceValues", ordered_json::array()},
      {"independentComponents", true},
      {"interpolationType", "linear"},
      {"useClippedVoxelIntensity", true},
      {"clippedVoxelIntensity", noClippedIntensity},
      {"scatteringAnisotropy", 0.0},
      {"components", ordered_json::array({component})}};
  written.text = textOf({{"@schema", schema}, {"volumeProperties", ordered_json::array({whole})}});
  return written;
}

} // namespace

LookFormat slicerTextFormat() {
  return {Message::tr("3D Slicer volume property (older)"),
          {".vp"},
          isSlicerText,
          readSlicerText,
          writeSlicerText};
}

LookFormat mrmlFormat() {
  return {Message::tr("3D Slicer scene or presets (MRML)"), {".xml"}, isMrml, readMrml, writeMrml};
}

LookFormat slicerJsonFormat() {
  return {
      Message::tr("3D Slicer volume property"), {".vp.json"}, isSlicerJson, readSlicerJson, writeSlicerJson};
}

} // namespace limn
