// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace limn::cpu {

/// The random numbers of one path: a pure function of seed, pixel, path and how many were asked for before,
/// so that whoever draws it, and when, draws the same. Numbers are the words of SplitMix64 (Steele, Lea,
/// Flood: Fast splittable pseudorandom number generators, 2014) from a start that those mix into.
class PathRandom {
public:
  PathRandom(std::uint32_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t path)
      : m_state(mixed(mixed(std::uint64_t{seed} << 32 | path) ^ (std::uint64_t{y} << 32 | x))) {}

  /// Evenly in [0, 1), a multiple of 2⁻²⁴.
  float next() {
    m_state += 0x9e3779b97f4a7c15u;
    return static_cast<float>(mixed(m_state) >> 40) * 0x1p-24f;
  }

private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t m_state;
};

} // namespace limn::cpu
