// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/ColorSpaces.h"

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

} // namespace limn
