// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <cmath>
#include <numbers>

namespace limn::test {

/// The signal of Marschner and Lobb (Visualization 1994) on [-1,1]³ with fM = 6 and alpha = 1/4, 0..1.
inline double marschnerLobb(const glm::dvec3& p) {
  constexpr double fM = 6.0, alpha = 0.25, pi = std::numbers::pi;
  const double r = std::hypot(p.x, p.y);
  const double ripple = std::cos(2.0 * pi * fM * std::cos(pi * r / 2.0));
  return (1.0 - std::sin(pi * p.z / 2.0) + alpha * (1.0 + ripple)) / (2.0 * (1.0 + alpha));
}

/// Its gradient; r > 0.
inline glm::dvec3 marschnerLobbGradient(const glm::dvec3& p) {
  constexpr double fM = 6.0, alpha = 0.25, pi = std::numbers::pi;
  const double r = std::hypot(p.x, p.y);
  const double phase = 2.0 * pi * fM * std::cos(pi * r / 2.0);
  const double alongR = alpha * std::sin(phase) * 2.0 * pi * fM * std::sin(pi * r / 2.0) * pi / 2.0;
  return glm::dvec3(alongR * p.x / r, alongR * p.y / r, -std::cos(pi * p.z / 2.0) * pi / 2.0) /
         (2.0 * (1.0 + alpha));
}

} // namespace limn::test
