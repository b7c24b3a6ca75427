// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/CurvedSegments.h"

#include "io/looks/curves/LookCurves.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

constexpr double pi = std::numbers::pi;
const glm::dvec3 whiteD65{0.95047, 1.0, 1.08883}; // CIE XYZ, 2° observer

glm::dvec3 hsvOf(const glm::dvec3& rgb) {
  const double highest = std::max({rgb.r, rgb.g, rgb.b});
  const double range = highest - std::min({rgb.r, rgb.g, rgb.b});
  if (range <= 0.0)
    return {0.0, 0.0, highest};
  double sixth = 4.0 + (rgb.r - rgb.g) / range;
  if (rgb.r == highest)
    sixth = (rgb.g - rgb.b) / range;
  else if (rgb.g == highest)
    sixth = 2.0 + (rgb.b - rgb.r) / range;
  return {sixth < 0.0 ? sixth / 6.0 + 1.0 : sixth / 6.0, range / highest, highest};
}

glm::dvec3 rgbOf(const glm::dvec3& hsv) {
  // Each channel is a trapezoid over the circle of hues.
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + 6.0 * (hsv.x - std::floor(hsv.x)), 6.0);
    return hsv.z - hsv.z * hsv.y * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

glm::dvec3 mixedHsv(glm::dvec3 from, glm::dvec3 to, double u, bool isWrapped) {
  from = hsvOf(from);
  to = hsvOf(to);
  if (isWrapped && std::abs(from.x - to.x) > 0.5)
    (from.x > to.x ? from.x : to.x) -= 1.0;
  return rgbOf(glm::mix(from, to, u));
}

// The transfer curve of IEC 61966-2-1.
double linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

// The matrices of IEC 61966-2-1, row by row in its text.
const glm::dmat3 xyzFromRgb{0.4124, 0.2126, 0.0193, 0.3576, 0.7152, 0.1192, 0.1805, 0.0722, 0.9505};
const glm::dmat3 rgbFromXyz = glm::inverse(xyzFromRgb);

// CIE 15: cube root above, straight below (6/29)³.
double labCurve(double t) {
  return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
}

double labCurveInverse(double f) {
  return f > 6.0 / 29.0 ? f * f * f : (116.0 * f - 16.0) * 27.0 / 24389.0;
}

glm::dvec3 labOf(const glm::dvec3& rgb) {
  const glm::dvec3 xyz = xyzFromRgb * glm::dvec3(linear(rgb.r), linear(rgb.g), linear(rgb.b)) / whiteD65;
  const glm::dvec3 f(labCurve(xyz.x), labCurve(xyz.y), labCurve(xyz.z));
  return {116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z)};
}

glm::dvec3 rgbOfLab(const glm::dvec3& lab) {
  const double y = (lab.x + 16.0) / 116.0;
  const glm::dvec3 f(y + lab.y / 500.0, y, y - lab.z / 200.0);
  const glm::dvec3 xyz = glm::dvec3(labCurveInverse(f.x), labCurveInverse(f.y), labCurveInverse(f.z));
  const glm::dvec3 rgb = rgbFromXyz * (xyz * whiteD65);
  return glm::clamp(glm::dvec3(encoded(rgb.r), encoded(rgb.g), encoded(rgb.b)), 0.0, 1.0);
}

// Msh: the length of a vector in L*a*b*, its angle to the grey axis, and the hue.
struct Msh {
  double magnitude = 0.0;
  double saturation = 0.0;
  double hue = 0.0;
};

constexpr double unsaturated = 0.05; // and below: its hue means nothing

Msh mshOf(const glm::dvec3& lab) {
  const double magnitude = glm::length(lab);
  return {magnitude, magnitude > 0.001 ? std::acos(std::clamp(lab.x / magnitude, -1.0, 1.0)) : 0.0,
          std::atan2(lab.z, lab.y)};
}

glm::dvec3 labOfMsh(const Msh& msh) {
  const double radius = msh.magnitude * std::sin(msh.saturation);
  return {msh.magnitude * std::cos(msh.saturation), radius * std::cos(msh.hue), radius * std::sin(msh.hue)};
}

// The hue that a colour without saturation takes, so that the way to it looks straight.
double adjustedHue(const Msh& saturated, double magnitude) {
  if (saturated.magnitude >= magnitude - 0.1)
    return saturated.hue;
  const double square = magnitude * magnitude - saturated.magnitude * saturated.magnitude;
  const double spin =
      saturated.saturation * std::sqrt(square) / (saturated.magnitude * std::sin(saturated.saturation));
  return saturated.hue > -0.3 * pi ? saturated.hue + spin : saturated.hue - spin;
}

double angleBetween(double a, double b) {
  const double turn = std::abs(a - b);
  return turn > pi ? 2.0 * pi - turn : turn;
}

glm::dvec3 mixedMsh(const glm::dvec3& from, const glm::dvec3& to, double u) {
  Msh a = mshOf(labOf(from));
  Msh b = mshOf(labOf(to));
  const bool bothSaturated = a.saturation > unsaturated && b.saturation > unsaturated;
  if (bothSaturated && angleBetween(a.hue, b.hue) > 0.33 * pi) {
    const double middle = std::max({a.magnitude, b.magnitude, 88.0});
    (u < 0.5 ? b : a) = {middle, 0.0, 0.0};
    u = u < 0.5 ? 2.0 * u : 2.0 * u - 1.0;
  }
  if (a.saturation < unsaturated && b.saturation > unsaturated)
    a.hue = adjustedHue(b, a.magnitude);
  else if (b.saturation < unsaturated && a.saturation > unsaturated)
    b.hue = adjustedHue(a, b.magnitude);
  return rgbOfLab(labOfMsh({std::lerp(a.magnitude, b.magnitude, u), std::lerp(a.saturation, b.saturation, u),
                            std::lerp(a.hue, b.hue, u)}));
}

// A curved segment is looked at so often; between two samples it strays less than the margin kept below.
constexpr int samples = 512;
constexpr double margin = 0.0005;

double clampedMidpoint(double midpoint) {
  return std::clamp(midpoint, 1e-5, 1.0 - 1e-5);
}

bool isStraight(double sharpness) {
  return sharpness < 0.01;
}

bool isStep(double sharpness) {
  return sharpness > 0.99;
}

// Half of the change is done at the midpoint.
double unwarped(double v, double midpoint) {
  return v < 0.5 ? 2.0 * v * midpoint : midpoint + 2.0 * (v - 0.5) * (1.0 - midpoint);
}

// How much of the change is done: VTK's rule (vtkPiecewiseFunction).
double bent(double v, double sharpness) {
  if (isStraight(sharpness))
    return v;
  const double exponent = 1.0 + 10.0 * sharpness;
  const double w =
      v < 0.5 ? 0.5 * std::pow(2.0 * v, exponent) : 1.0 - 0.5 * std::pow(2.0 * (1.0 - v), exponent);
  // A cubic from 0 to 1 with the tangent 1 - sharpness at both ends.
  const double cubic = w * w * (3.0 - 2.0 * w);
  const double tangents = w * (1.0 - w) * (1.0 - 2.0 * w);
  return std::clamp(cubic + (1.0 - sharpness) * tangents, 0.0, 1.0);
}

/// One segment.
class Segment {
public:
  Segment(const BentPoint& from, const BentPoint& to, const SegmentRule& rule)
      : m_from(from.point), m_to(to.point), m_rule(rule), m_midpoint(clampedMidpoint(from.midpoint)),
        m_sharpness(from.sharpness) {}

  bool isEmpty() const { return !(m_to.value > m_from.value); }

  /// Appends what lies between the ends. False where that is exact.
  bool appendTo(std::vector<ControlPoint>& points) const {
    if (isEmpty())
      return false;
    if (m_rule.space == ColorSpace::step || isStep(m_sharpness)) {
      appendStep(points);
      return false;
    }
    const bool changes = m_from.color != m_to.color || m_from.opacity != m_to.opacity;
    const bool isRgb = m_rule.space == ColorSpace::rgb || m_from.color == m_to.color;
    if (!changes || (isRgb && isStraight(m_sharpness) && !m_rule.isLogarithmic)) {
      if (changes && m_midpoint != 0.5)
        points.push_back(at(0.5));
      return false;
    }
    appendCurve(points);
    return true;
  }

private:
  double valueAt(double u) const {
    if (m_rule.isLogarithmic)
      return std::clamp(m_from.value * std::pow(m_to.value / m_from.value, u), m_from.value, m_to.value);
    return m_from.value * (1.0 - u) + m_to.value * u;
  }

  // Where `v` counts the way so that 0.5 is the midpoint.
  ControlPoint at(double v) const {
    const double done = bent(v, m_sharpness);
    return {valueAt(unwarped(v, m_midpoint)), mixed(m_rule.space, m_from.color, m_to.color, done),
            m_from.opacity + done * (m_to.opacity - m_from.opacity)};
  }

  void appendStep(std::vector<ControlPoint>& points) const {
    const bool isAtStart = m_rule.space == ColorSpace::step;
    if (!isAtStart)
      points.push_back({valueAt(m_midpoint), m_from.color, m_from.opacity});
    points.push_back({isAtStart ? m_from.value : valueAt(m_midpoint), m_to.color, m_to.opacity});
  }

  void appendCurve(std::vector<ControlPoint>& points) const {
    std::vector<ControlPoint> seen{m_from};
    for (int i = 1; i < samples; ++i)
      if (const ControlPoint point = at(i / double(samples)); point.value > seen.back().value)
        seen.push_back(point);
    if (seen.back().value < m_to.value)
      seen.push_back(m_to);
    else
      seen.back() = m_to;
    const std::vector<ControlPoint> kept = simplified(seen, segmentTolerance - margin);
    points.insert(points.end(), kept.begin() + 1, kept.end() - 1);
  }

  ControlPoint m_from;
  ControlPoint m_to;
  SegmentRule m_rule;
  double m_midpoint;
  double m_sharpness;
};

void requireSoundRule(const std::vector<BentPoint>& points, const SegmentRule& rule,
                      const std::string& name) {
  if (rule.isLogarithmic && !points.empty() && !(points.front().point.value > 0.0))
    failReading(name, Message::tr("its scale is logarithmic, but not all of its values are above 0"),
                Message::tr("save it with a linear scale"));
}

} // namespace

glm::dvec3 mixed(ColorSpace space, const glm::dvec3& from, const glm::dvec3& to, double u) {
  switch (space) {
  case ColorSpace::rgb:
    return glm::mix(from, to, u);
  case ColorSpace::hsv:
  case ColorSpace::wrappedHsv:
    return mixedHsv(from, to, u, space == ColorSpace::wrappedHsv);
  case ColorSpace::lab:
    return rgbOfLab(glm::mix(labOf(from), labOf(to), u));
  case ColorSpace::diverging:
    return mixedMsh(from, to, u);
  case ColorSpace::step:
    break;
  }
  return to;
}

std::vector<BentPoint> checkedCurve(std::vector<BentPoint> points, const std::string& name,
                                    std::vector<Message>& changes) {
  requirePointCount(points.size(), name);
  for (BentPoint& bent : points) {
    if (!std::isfinite(bent.midpoint) || !std::isfinite(bent.sharpness))
      failReading(name, Message::tr("a midpoint or sharpness in it is no number"), saveLookAgain);
    bent.point = checkedPoint(bent.point, name, changes);
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const BentPoint& a, const BentPoint& b) { return a.point.value < b.point.value; });
  return points;
}

static bool isOpacityStep(const BentPoint& from, const BentPoint& to) {
  return isStep(from.sharpness) && from.point.opacity != to.point.opacity &&
         from.point.value < to.point.value;
}

std::vector<ControlPoint> straightened(const std::vector<BentPoint>& points, const SegmentRule& rule,
                                       const std::string& name, std::vector<Message>& changes) {
  requireSoundRule(points, rule, name);
  std::vector<ControlPoint> straight;
  for (std::size_t i = 0; i < points.size(); ++i) {
    straight.push_back(points[i].point);
    if (i + 1 < points.size() && isOpacityStep(points[i], points[i + 1]))
      tell(changes,
           Message::tr("Where the opacity is fully sharp it steps, as it was meant; programs on VTK since "
                       "2023 draw a ramp there by mistake."));
    if (i + 1 < points.size() && Segment(points[i], points[i + 1], rule).appendTo(straight))
      tell(changes, Message::tr("Curved segments became straight ones that differ from them by at most %1.")
                        .arg(Message::rounded(segmentTolerance, 2)));
    if (straight.size() > mostLookPoints)
      failReading(
          name, Message::tr("straight segments for its curves need more than %1 points").arg(mostLookPoints),
          Message::tr("save it with fewer points"));
  }
  return straight;
}

} // namespace limn
