// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "LookText.h"

#include <array>
#include <functional>

namespace limn::test {

using Rgba = std::array<double, 4>;

/// Compares a curve with what a test says it is, at many values between and around two.
inline void expectCurve(const TransferFunction& function, double low, double high, double tolerance,
                        const std::function<Rgba(double)>& expected) {
  const double margin = 0.1 * (high - low);
  const auto classified = [&](double value) {
    const Rgba rgba = expected(value);
    return Classified{{rgba[0], rgba[1], rgba[2]}, rgba[3]};
  };
  // A prime number of steps meets no point of a curve.
  EXPECT_LE(largestDifference(function, classified, low - margin, high + margin, 997), tolerance);
}

/// A straight line between two values, and the ends beyond them.
inline double ramp(double x, double x0, double y0, double x1, double y1) {
  if (x <= x0)
    return y0;
  return x >= x1 ? y1 : y0 + (x - x0) * (y1 - y0) / (x1 - x0);
}

inline const LookTarget ctTarget{-1000.0, 3000.0, 0.7};

inline double stretched(double fraction) {
  return -1000.0 + 4000.0 * fraction;
}

} // namespace limn::test
