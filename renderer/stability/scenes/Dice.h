// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace limn {

/// Random numbers that are the same on every machine: the generator is defined bit by bit, and numbers are
/// made of its bits without the distributions and functions of a library, which may round otherwise.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : m_generator(seed) {}

  std::uint64_t bits() { return m_generator(); }

  /// 0 ≤ x < 1.
  double fraction() { return std::ldexp(static_cast<double>(m_generator() >> 11), -53); }
  double between(double low, double high) { return low + (high - low) * fraction(); }

  /// 2^first ≤ x < 2^last, each octave as likely as another.
  double octaves(int first, int last) { return std::ldexp(1.0 + fraction(), first + upTo(last - first)); }

  /// 0, 1, … count - 1.
  int upTo(int count) { return static_cast<int>(m_generator() % static_cast<std::uint64_t>(count)); }
  bool oneIn(int count) { return upTo(count) == 0; }
  double sign() { return oneIn(2) ? 1.0 : -1.0; }

  glm::dvec3 vector(double low, double high) {
    const double x = between(low, high);
    const double y = between(low, high);
    return {x, y, between(low, high)};
  }

  /// A vector of unit length, each direction possible.
  glm::dvec3 direction() {
    const glm::dvec3 v = vector(-1.0, 1.0);
    const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return length > 0.0 ? v / length : glm::dvec3(1.0, 0.0, 0.0);
  }

  template <class T, std::size_t count>
  const T& oneOf(const std::array<T, count>& values) {
    return values[static_cast<std::size_t>(upTo(static_cast<int>(count)))];
  }

private:
  std::mt19937_64 m_generator;
};

} // namespace limn
