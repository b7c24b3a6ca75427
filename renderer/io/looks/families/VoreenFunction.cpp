// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/CurvedSegments.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/families/Families.h"
#include "io/looks/families/XmlText.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

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

LookFormat voreenFunctionFormat() {
  return {Message::tr("Voreen transfer function"), {".tfi"}, isVoreenFunction, readVoreenFunction, nullptr};
}

} // namespace limn
