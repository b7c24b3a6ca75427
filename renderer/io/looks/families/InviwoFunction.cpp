// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/XmlText.h"
#include "io/looks/text/LookText.h"
#include "io/reading/ReadError.h"

#include <limits>

namespace limn {
namespace {

constexpr double lowestMask = std::numeric_limits<double>::lowest(); // of absolute values: none
constexpr double highestMask = std::numeric_limits<double>::max();

bool isInviwoFunction(std::string_view text) {
  return text.find("<InviwoTreeData") != std::string_view::npos ||
         text.find("<InviwoWorkspace") != std::string_view::npos;
}

// The first generation calls the list <dataPoints><point>, the later ones <Points><Point>.
pugi::xml_node listOf(const pugi::xml_node& root) {
  const pugi::xml_node early = root.child("dataPoints");
  return early ? early : root.child("Points");
}

ControlPoint pointOf(const pugi::xml_node& point, const std::string& file) {
  const pugi::xml_node position = point.child("pos"), color = point.child("rgba");
  const bool isEarly = !position.attribute("content");
  ControlPoint read;
  read.value = attributeOf(position, isEarly ? "x" : "content", file);
  read.color = {attributeOf(color, "x", file), attributeOf(color, "y", file), attributeOf(color, "z", file)};
  const std::optional<double> opacity = attributeIn(color, "w", file);
  read.opacity = opacity ? *opacity : attributeOf(position, "y", file);
  return read;
}

// What lies outside the mask is transparent. Relative values have no outside of 0..1.
void mask(PointLook& look, const pugi::xml_node& root, const std::string& file) {
  double low = attributeIn(root.child("maskMin"), "content", file).value_or(lowestMask);
  double high = attributeIn(root.child("maskMax"), "content", file).value_or(highestMask);
  if (!(low < high))
    failReading(file, Message::tr("its mask hides all values"),
                Message::tr("clear the mask in Inviwo and save it again"));
  constexpr double none = std::numeric_limits<double>::infinity();
  low = low <= (look.isRelative ? 0.0 : lowestMask) ? -none : low;
  high = high >= (look.isRelative ? 1.0 : highestMask) ? none : high;
  if (low == -none && high == none)
    return;
  look.points = maskedTo(checkedCurve(std::move(look.points), file, look.changes), low, high);
  tell(look.changes, Message::tr("Its mask became points, outside which the opacity is 0."));
}

std::vector<ReadLook> readInviwoFunction(std::string_view text, const std::string& file,
                                         const std::optional<LookTarget>& target) {
  const pugi::xml_document document = parsedXml(text, file);
  const pugi::xml_node root = document.document_element();
  const pugi::xml_node list = listOf(root);
  if (!list)
    failReading(file, Message::tr("it is a file of Inviwo without a transfer function of its own"),
                Message::tr("save the transfer function alone (.itf) in Inviwo"));
  PointLook look;
  for (const pugi::xml_node& point : list.children())
    if (point.type() == pugi::node_element)
      look.points.push_back(pointOf(point, file));
  look.isRelative = attributeIn(root.child("type"), "content", file).value_or(0.0) == 0.0;
  if (attributeIn(root.child("interpolationType_"), "content", file).value_or(0.0) != 0.0)
    tell(look.changes, Message::tr("Its points are joined by curves, which became straight lines."));
  mask(look, root, file);
  return finished(std::move(look), file, target);
}

void append(pugi::xml_node& parent, const char* name, double content) {
  parent.append_child(name).append_attribute("content") = shortest(content).c_str();
}

WrittenLook writeInviwoFunction(const Preset& preset, const std::optional<LookTarget>&) {
  std::vector<Message> changes;
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  pugi::xml_node root = document.append_child("InviwoWorkspace");
  root.append_attribute("version") = "3";
  // Left out, the mask would be 0..1 also of absolute values.
  append(root, "maskMin", lowestMask);
  append(root, "maskMax", highestMask);
  append(root, "type", 1.0);
  pugi::xml_node points = root.append_child("Points");
  for (const ControlPoint& point : pointsAlone(preset, changes).points) {
    pugi::xml_node written = points.append_child("Point");
    append(written, "pos", point.value);
    pugi::xml_node color = written.append_child("rgba");
    const auto channel = [&](const char* name, double value) {
      color.append_attribute(name) = shortest(value).c_str();
    };
    channel("x", point.color.r);
    channel("y", point.color.g);
    channel("z", point.color.b);
    channel("w", point.opacity);
  }
  return {textOf(document), changes};
}

} // namespace

LookFormat inviwoFunctionFormat() {
  return {Message::tr("Inviwo transfer function"),
          {".itf"},
          isInviwoFunction,
          readInviwoFunction,
          writeInviwoFunction};
}

} // namespace limn
