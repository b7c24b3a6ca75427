// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/CurvedSegments.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/curves/LookUnits.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/XmlText.h"
#include "io/looks/text/LookText.h"
#include "io/reading/ReadError.h"

#include <cmath>
#include <limits>

namespace limn {
namespace {

bool isMitkFunction(std::string_view text) {
  return text.find("<TransferFunction") != std::string_view::npos &&
         text.find("<ScalarOpacity") != std::string_view::npos;
}

std::vector<ControlPoint> opacitiesIn(const pugi::xml_node& list, const std::string& file) {
  std::vector<ControlPoint> points;
  for (const pugi::xml_node& point : list.children("point"))
    points.push_back({attributeOf(point, "x", file), glm::dvec3(1.0), attributeOf(point, "y", file)});
  return points;
}

std::vector<BentPoint> colorsIn(const pugi::xml_node& list, const std::string& file) {
  std::vector<BentPoint> points;
  for (const pugi::xml_node& point : list.children("point")) {
    const glm::dvec3 color(attributeOf(point, "r", file), attributeOf(point, "g", file),
                           attributeOf(point, "b", file));
    points.push_back({{attributeOf(point, "x", file), color, 0.0},
                      attributeIn(point, "midpoint", file).value_or(0.5),
                      attributeIn(point, "sharpness", file).value_or(0.0)});
  }
  return points;
}

std::vector<ReadLook> readMitkFunction(std::string_view text, const std::string& file,
                                       const std::optional<LookTarget>& target) {
  // The file has two roots: the version and the function.
  const pugi::xml_document document = parsedXml(text, file);
  const pugi::xml_node function = document.child("TransferFunction");
  ReadLook look;
  look.preset.name = lookNameOf(file);
  const auto opacity = checkedCurve(opacitiesIn(function.child("ScalarOpacity"), file), file, look.changes);
  const auto colors = checkedCurve(colorsIn(function.child("Color"), file), file, look.changes);
  look.preset.transferFunction = merged(opacity, straightened(colors, {}, file, look.changes), look.changes);
  const auto gradients = opacitiesIn(function.child("GradientOpacity"), file);
  if (!gradients.empty())
    look.preset.gradientOpacity =
        gradientOpacityFromVtk(checkedCurve(gradients, file, look.changes), target, look.changes);
  return {std::move(look)};
}

void appendNumber(pugi::xml_node& point, const char* name, double number) {
  point.append_attribute(name) = shortest(number).c_str();
}

/// The values of points for a program that keeps one point of each value: of a step, the left one lies as
/// near as there is a number. Where more share a value, only two are seen, so the others are absent.
std::vector<ControlPoint> withSingleValues(const std::vector<ControlPoint>& points) {
  std::vector<ControlPoint> single;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isFirst = i == 0 || points[i - 1].value != points[i].value;
    const bool isLast = i + 1 == points.size() || points[i + 1].value != points[i].value;
    if (!isFirst && !isLast)
      continue;
    single.push_back(points[i]);
    if (isFirst && !isLast)
      single.back().value = std::nextafter(points[i].value, std::numeric_limits<double>::lowest());
  }
  return single;
}

void appendFunction(pugi::xml_node function, const std::vector<ControlPoint>& points,
                    const std::vector<GradientOpacityPoint>& gradients) {
  pugi::xml_node opacities = function.append_child("ScalarOpacity");
  for (const ControlPoint& point : points) {
    pugi::xml_node written = opacities.append_child("point");
    appendNumber(written, "x", point.value);
    appendNumber(written, "y", point.opacity);
  }
  pugi::xml_node byGradient = function.append_child("GradientOpacity");
  for (const GradientOpacityPoint& point : gradients) {
    pugi::xml_node written = byGradient.append_child("point");
    appendNumber(written, "x", point.gradient);
    appendNumber(written, "y", point.opacity);
  }
  pugi::xml_node colors = function.append_child("Color");
  for (const ControlPoint& point : points) {
    pugi::xml_node written = colors.append_child("point");
    appendNumber(written, "x", point.value);
    appendNumber(written, "r", point.color.r);
    appendNumber(written, "g", point.color.g);
    appendNumber(written, "b", point.color.b);
    appendNumber(written, "midpoint", 0.5);
    appendNumber(written, "sharpness", 0.0);
  }
}

WrittenLook writeMitkFunction(const Preset& preset, const std::optional<LookTarget>& target) {
  std::vector<Message> changes;
  Preset ofPoints = preset;
  ofPoints.gradientOpacity.reset(); // which this format holds
  const TransferFunction function = pointsAlone(ofPoints, changes);
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  document.append_child("Version").append_attribute("TransferfunctionVersion") = 1;
  appendFunction(document.append_child("TransferFunction"), withSingleValues(function.points),
                 gradientOpacityForVtk(preset.gradientOpacity, target, changes));
  return {textOf(document), std::move(changes)};
}

} // namespace

LookFormat mitkFunctionFormat() {
  return {Message::tr("MITK transfer function"),
          {".mitk.xml"},
          isMitkFunction,
          readMitkFunction,
          writeMitkFunction};
}

} // namespace limn
