// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

/// The formulas of the definition in forms that lose no digits, in double. `shaders/stable_math.glsl` holds a
/// twin of each function in float under the same name; the GL tests compare the two over their whole range.
namespace limn {

/// The largest opacity that becomes an extinction, 1 - 2⁻²⁴: -log1p(-1) would be infinite.
inline constexpr double largestOpacity = 1.0 - 1.0 / 16777216.0;

/// A vector shorter than this has no direction: half vectors of light against view.
inline constexpr double shortestHalfVector = 1e-6;

/// 1 - e^-x for x ≥ 0, without cancellation near 0.
inline double oneMinusExpNeg(double x) {
  return -std::expm1(-x);
}

/// -log(1-a), the extinction over the unit distance, with `a` limited to [0, largestOpacity].
inline double minusLog1mOpacity(double a) {
  return -std::log1p(-std::clamp(a, 0.0, largestOpacity));
}

/// -∫ log(1 - x s) ds over s in 0..1, for 0 ≤ x ≤ largestOpacity: the mean extinction over the unit distance
/// where the opacity rises linearly from 0 to x.
inline double meanMinusLog1m(double x) {
  if (x < 0.02) // the series' next term is below 1e-17 of the sum
    return x * (1.0 / 2.0 +
                x * (1.0 / 6.0 +
                     x * (1.0 / 12.0 +
                          x * (1.0 / 20.0 +
                               x * (1.0 / 30.0 +
                                    x * (1.0 / 42.0 + x * (1.0 / 56.0 + x * (1.0 / 72.0 + x / 90.0))))))));
  return 1.0 - (1.0 - x) * minusLog1mOpacity(x) / x;
}

/// -∫ s log(1 - x s) ds over s in 0..1, for 0 ≤ x ≤ largestOpacity: the same, weighted by the place in 0..1.
inline double momentMinusLog1m(double x) {
  if (x < 0.02)
    return x * (1.0 / 3.0 +
                x * (1.0 / 8.0 +
                     x * (1.0 / 15.0 +
                          x * (1.0 / 24.0 +
                               x * (1.0 / 35.0 +
                                    x * (1.0 / 48.0 + x * (1.0 / 63.0 + x * (1.0 / 80.0 + x / 99.0))))))));
  return (0.5 + 0.25 * x - (1.0 - x) * (1.0 + x) * minusLog1mOpacity(x) / (2.0 * x)) / x;
}

/// Unit vector (xyz) and length (w); zero for a vector that is zero or not finite.
inline glm::dvec4 safeNormal(const glm::dvec3& v) {
  const double m = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(m > 0.0) || !std::isfinite(m))
    return glm::dvec4(0.0);
  const glm::dvec3 q = v / m;
  const double l = glm::length(q);
  return {q / l, m * l};
}

/// max(0, cosine)^exponent with cosine limited to 1; 0 for cosine ≤ 0 whatever the exponent.
inline double blinnTerm(double cosine, double exponent) {
  return cosine > 0.0 ? std::pow(std::min(cosine, 1.0), exponent) : 0.0;
}

/// Scales a colour so that its largest channel m > k becomes 1 - (1-k)²/(m+1-2k); keeps the hue.
inline glm::dvec3 knee(const glm::dvec3& color, double k) {
  const double m = std::max({color.r, color.g, color.b});
  if (!(m > k))
    return color;
  const double d = 1.0 - k;
  return color * ((1.0 - d * d / (m + 1.0 - 2.0 * k)) / m);
}

/// (SP+8)/(SPmax+8), the energy of a highlight relative to that of the largest exponent.
inline double energyFactor(double exponent, double largestExponent) {
  return (exponent + 8.0) / (largestExponent + 8.0);
}

/// smoothstep(low, high, r); a step at `high` where the two are equal.
inline double significanceWeight(double low, double high, double r) {
  if (!(high > low))
    return r >= high ? 1.0 : 0.0;
  const double x = std::clamp((r - low) / (high - low), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// r^gamma, 0 at 0.
inline double gammaCurve(double r, double gamma) {
  return r > 0.0 ? std::pow(r, gamma) : 0.0;
}

/// log(1+x) for x ≥ 0, without cancellation near 0.
inline double logOnePlus(double x) {
  return std::log1p(x);
}

/// log1p(b r)/log1p(b) for b > 0.
inline double logCurve(double r, double b) {
  return logOnePlus(b * r) / logOnePlus(b);
}

/// low + x (high - low), the maps of paper eq. 7 and 8 (SPmin..SPmax, Omin..Omax).
inline double mapped(double x, double low, double high) {
  return x * (high - low) + low;
}

/// Fog factors: the weight of the object's colour at distance `z` mm from the eye.
inline double fogLinear(double z, double start, double end) {
  if (!(end > start))
    return z < start ? 1.0 : 0.0;
  return std::clamp((end - z) / (end - start), 0.0, 1.0);
}
inline double fogExp(double z, double start, double density) {
  return std::exp(-density * std::max(0.0, z - start));
}
inline double fogExp2(double z, double start, double density) {
  const double x = density * std::max(0.0, z - start);
  return std::exp(-x * x);
}

} // namespace limn
