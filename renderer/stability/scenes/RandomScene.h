// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <cstdint>
#include <string>

namespace limn {

/// A scene that a seed chose.
struct RandomScene {
  Scene scene;
  glm::ivec2 size{16, 16}; ///< pixels
  /// Unlit, without surface, its field reproduced exactly between voxels and its control points well apart:
  /// the double-precision reference must agree with every renderer within rounding.
  bool isComparable = false;
  bool isSliceable = false; ///< composite or X-ray with few enough steps for the slice renderer
  std::string description;  ///< one line for a reader
};

/// Seeds are drawn in blocks of so many: a block shares a few choices of effects, so that a renderer compiles
/// few programs for it. Over many blocks every combination comes up.
inline constexpr std::uint64_t seedsPerBlock = 192;

/// The scene of a seed, the same on every machine (HARD_CASES section 5): volume, camera, 0 to 8 control
/// points, light, fog, crop, projection and quality within what a scene file may say, at and beyond what
/// anybody would choose; its rays take at most 60000 samples. Throws Error (input) where the volume drawn is
/// one that Volume refuses.
RandomScene randomScene(std::uint64_t seed);

} // namespace limn
