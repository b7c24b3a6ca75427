// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/CurvedSegments.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/text/LookText.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace limn {
namespace {

/// A text as XML, also with several roots. Throws Error (input), naming `file`, where it is damaged.
pugi::xml_document parsedXml(std::string_view text, const std::string& file) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result)
    failReading(file, Message::tr("it is damaged or cut off (near its character %1)").arg(result.offset),
                saveLookAgain);
  return document;
}

/// A number in an attribute, in the C locale, "nan" and "inf" too; absent where there is no such attribute.
/// Throws Error (input), naming `file`, where it is no number.
std::optional<double> attributeIn(const pugi::xml_node& node, const char* attribute,
                                  const std::string& file) {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found)
    return std::nullopt;
  const std::string_view text = trimmed(found.value());
  const std::optional<double> number = numberIn(text);
  if (!number)
    failReading(file,
                Message::tr("its \"%1\" of \"%2\" is \"%3\" and no number")
                    .arg(attribute, node.name(), std::string(text.substr(0, 40))),
                saveLookAgain);
  return number;
}

/// The same of an attribute that there must be.
double attributeOf(const pugi::xml_node& node, const char* attribute, const std::string& file) {
  const std::optional<double> number = attributeIn(node, attribute, file);
  if (!number)
    failReading(file, Message::tr("its \"%1\" lacks \"%2\"").arg(node.name(), attribute), saveLookAgain);
  return *number;
}

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
  return {xmlText(document), std::move(changes)};
}

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
  return {xmlText(document), changes};
}

bool isVoreenFunction(std::string_view text) {
  return text.find("<VoreenData") != std::string_view::npos;
}

/// A key: colour and opacity as they arrive from the left and go on to the right, at 0..1 of the domain.
struct Key {
  double intensity = 0.0;
  glm::dvec4 left{0.0}, right{0.0};
};

struct Range {
  double low = 0.0;
  double high = 1.0;
};

glm::dvec4 bytesOf(const pugi::xml_node& color, const std::string& file) {
  return glm::dvec4(attributeOf(color, "r", file), attributeOf(color, "g", file),
                    attributeOf(color, "b", file), attributeOf(color, "a", file)) /
         255.0;
}

ControlPoint pointOf(double value, const glm::dvec4& rgba) {
  return {value, glm::dvec3(rgba), rgba.a};
}

Key keyOf(const pugi::xml_node& node, const std::string& file, std::vector<Message>& changes) {
  Key key;
  key.intensity = attributeOf(node.child("intensity"), "value", file);
  const auto color = [&](const char* name) {
    const ControlPoint point =
        checkedPoint(pointOf(key.intensity, bytesOf(node.child(name), file)), file, changes);
    return glm::dvec4(point.color, point.opacity);
  };
  const bool isSplit = std::string_view(node.child("split").attribute("value").value()) == "true";
  key.left = color("colorL");
  key.right = isSplit ? color("colorR") : key.left;
  return key;
}

Range rangeOf(const pugi::xml_node& function, const char* name, const std::string& file) {
  const pugi::xml_node range = function.child(name);
  return {attributeIn(range, "x", file).value_or(0.0), attributeIn(range, "y", file).value_or(1.0)};
}

// Old files have both ends as elements of their own.
Range thresholdOf(const pugi::xml_node& function, const std::string& file) {
  if (function.child("threshold"))
    return rangeOf(function, "threshold", file);
  return {attributeIn(function.child("lower"), "value", file).value_or(0.0),
          attributeIn(function.child("upper"), "value", file).value_or(1.0)};
}

/// Points of what is joined by straight lines, or with opacities that are 0 or 1 alone.
std::vector<ControlPoint> pointsOf(const std::vector<Key>& keys) {
  std::vector<ControlPoint> points;
  for (const Key& key : keys) {
    points.push_back(pointOf(key.intensity, key.left));
    if (key.right != key.left)
      points.push_back(pointOf(key.intensity, key.right));
  }
  return points;
}

// Voreen's modes of opacity: none, as it is, all of what is seen at all.
void setAlphaMode(std::vector<Key>& keys, double mode, std::vector<Message>& changes) {
  if (mode == 0.0) {
    for (Key& key : keys)
      key.left.a = key.right.a = 0.0;
    tell(changes, Message::tr("Its opacity is switched off, so that nothing is seen."));
  }
  if (mode != 2.0 || keys.empty())
    return;
  keys.front().left.a = keys.front().left.a > 0.0 ? 1.0 : 0.0;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i)
    keys[i].right.a = keys[i + 1].left.a = keys[i].right.a > 0.0 || keys[i + 1].left.a > 0.0 ? 1.0 : 0.0;
  keys.back().right.a = keys.back().right.a > 0.0 ? 1.0 : 0.0;
  tell(changes, Message::tr("It shows all that is seen at all as opaque, which became steps."));
}

/// How far the power t^gamma between two of its values `from` < `to` lies from a straight line; 0..to - from.
double distanceFromLine(double from, double to, double gamma) {
  const double start = std::pow(from, 1.0 / gamma), end = std::pow(to, 1.0 / gamma);
  if (!(start < end))
    return 0.0;
  const double slope = (to - from) / (end - start);
  const double steepAs = std::pow(slope / gamma, 1.0 / (gamma - 1.0)); // there it is furthest
  const double furthest = std::clamp(steepAs, start, end);
  return std::abs(std::pow(furthest, gamma) - (from + slope * (furthest - start)));
}

double largestChange(const ControlPoint& from, const ControlPoint& to) {
  const glm::dvec3 color = glm::abs(to.color - from.color);
  return std::max({std::abs(to.opacity - from.opacity), color.r, color.g, color.b});
}

/// Voreen looks a value t up at t^gamma: the points where that puts them, and between them enough that
/// straight lines lie within the tolerance. `points` are ascending within 0..1.
std::vector<ControlPoint> withGamma(const std::vector<ControlPoint>& points, double gamma) {
  std::vector<ControlPoint> curve;
  const auto add = [&](ControlPoint point) {
    point.value = std::pow(point.value, 1.0 / gamma);
    curve.push_back(point);
  };
  const auto refine = [&](const auto& self, const ControlPoint& from, const ControlPoint& to) -> void {
    const double change = largestChange(from, to); // halves each time
    const double width = to.value - from.value;
    if (change <= segmentTolerance || width <= 0.0 ||
        change * distanceFromLine(from.value, to.value, gamma) <= segmentTolerance * width)
      return;
    const ControlPoint middle{0.5 * (from.value + to.value), 0.5 * (from.color + to.color),
                              0.5 * (from.opacity + to.opacity)};
    self(self, from, middle);
    add(middle);
    self(self, middle, to);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0)
      refine(refine, points[i - 1], points[i]);
    add(points[i]);
  }
  return curve;
}

void applyGamma(PointLook& look, const pugi::xml_node& function, const std::string& file) {
  const double gamma = attributeIn(function.child("gammaValue"), "value", file).value_or(1.0);
  if (gamma == 1.0)
    return;
  if (!(gamma >= 0.01 && gamma <= 100.0))
    failReading(file, Message::tr("its gamma is %1").arg(Message::rounded(gamma, 6)), saveLookAgain);
  for (ControlPoint& point : look.points)
    point.value = std::clamp(point.value, 0.0, 1.0);
  look.points = withGamma(look.points, gamma);
  tell(look.changes, Message::tr("Its gamma of %1 became points, within %2 of the curve.")
                         .arg(Message::rounded(gamma, 6), Message::rounded(segmentTolerance, 2)));
}

void applyThreshold(PointLook& look, const pugi::xml_node& function, const std::string& file) {
  const Range seen = thresholdOf(function, file);
  if (!(seen.low < seen.high))
    failReading(file, Message::tr("its threshold hides all values"),
                Message::tr("widen the threshold in Voreen and save it again"));
  if (seen.low <= 0.0 && seen.high >= 1.0)
    return;
  constexpr double none = std::numeric_limits<double>::infinity();
  look.points =
      maskedTo(look.points, seen.low <= 0.0 ? -none : seen.low, seen.high >= 1.0 ? none : seen.high);
  tell(look.changes, Message::tr("Its threshold became points, outside which the opacity is 0."));
}

// The default, 0..1, is also what a function has that was never fitted to the values of a volume.
void placeIn(PointLook& look, const Range& domain, const std::string& file) {
  if (!(domain.low < domain.high))
    failReading(file, Message::tr("its range of values ends before it begins"), saveLookAgain);
  look.isRelative = domain.low == 0.0 && domain.high == 1.0;
  for (ControlPoint& point : look.points)
    point.value = domain.low + point.value * (domain.high - domain.low);
}

pugi::xml_node functionIn(const pugi::xml_document& document, const std::string& file) {
  const pugi::xml_node root = document.child("VoreenData");
  if (const pugi::xml_node function = root.child("TransFuncIntensity"); function.child("Keys"))
    return function;
  failReading(file, Message::tr("it is a file of Voreen without a transfer function of values"),
              Message::tr("save a one-dimensional transfer function (.tfi) in Voreen"));
}

std::vector<ReadLook> readVoreenFunction(std::string_view text, const std::string& file,
                                         const std::optional<LookTarget>& target) {
  const pugi::xml_document document = parsedXml(text, file);
  const pugi::xml_node function = functionIn(document, file);
  PointLook look;
  std::vector<Key> keys;
  for (const pugi::xml_node& key : function.child("Keys").children("key"))
    keys.push_back(keyOf(key, file, look.changes));
  std::ranges::stable_sort(keys, {}, &Key::intensity);
  setAlphaMode(keys, attributeIn(function.child("alphaMode"), "value", file).value_or(1.0), look.changes);
  look.points = checkedCurve(pointsOf(keys), file, look.changes);
  applyGamma(look, function, file);
  applyThreshold(look, function, file);
  placeIn(look, rangeOf(function, "domain", file), file);
  return finished(std::move(look), file, target);
}

} // namespace

LookFormat mitkFunctionFormat() {
  return {Message::tr("MITK transfer function"),
          {".mitk.xml"},
          isMitkFunction,
          readMitkFunction,
          writeMitkFunction};
}

LookFormat inviwoFunctionFormat() {
  return {Message::tr("Inviwo transfer function"),
          {".itf"},
          isInviwoFunction,
          readInviwoFunction,
          writeInviwoFunction};
}

LookFormat voreenFunctionFormat() {
  return {Message::tr("Voreen transfer function"), {".tfi"}, isVoreenFunction, readVoreenFunction, nullptr};
}

} // namespace limn
