// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <variant>

namespace limn {

/// When random paths are enough: so many of each pixel; a standard error whose root mean square over the
/// picture is so many of 255 levels; or so long.
struct UntilPaths {
  int paths = 256; ///< 1 … 10⁷
  bool operator==(const UntilPaths&) const = default;
};
struct UntilLevels {
  double levels = 1.0; ///< > 0, at most 255
  bool operator==(const UntilLevels&) const = default;
};
struct UntilSeconds {
  double seconds = 10.0; ///< > 0, at most a year
  bool operator==(const UntilSeconds&) const = default;
};
using Until = std::variant<UntilPaths, UntilLevels, UntilSeconds>;

inline constexpr int mostPaths = 10'000'000;
inline constexpr double mostPathSeconds = 366.0 * 24.0 * 3600.0;

/// How many paths a pixel gets where nobody counts levels or seconds.
inline int pathsOf(const Until& until) {
  const auto* paths = std::get_if<UntilPaths>(&until);
  return paths ? paths->paths : UntilPaths{}.paths;
}

/// Radiance of the sky, linear in the cosine with what is up.
struct Sky {
  double below = 0.3; ///< ≥ 0
  double above = 0.3; ///< ≥ 0
  bool operator==(const Sky&) const = default;
};

/// Every number of physical light (DEFINITION section 12).
struct PhysicalLight {
  double density = 1.0;                          ///< of the curve's extinction, 0.01..100
  double anisotropy = 0.0;                       ///< g of volume events, -0.95..0.95
  double surface = 0.7;                          ///< the most of collisions that surfaces take, 0..1
  double specularShare = 0.1;                    ///< k of a surface, 0..1
  double keyIrradiance = 3.14159265358979323846; ///< E ≥ 0; π: a white face turned to it has radiance 1
  double keyRadiusDeg = 4.0;                     ///< ρ, 0..45: the angular radius of the key
  Sky sky;
  double exposureEv = 0.0; ///< of the picture, -20..20: each step doubles its light
  std::uint32_t seed = 1;
  Until until;
  bool filtersNoise = false; ///< what is left of it, in pictures that are saved
  bool operator==(const PhysicalLight&) const = default;
};

} // namespace limn
