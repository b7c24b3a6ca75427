// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Error.h"
#include "scene/Grid.h"

#include <cstdio>
#include <filesystem>

namespace limn {

/// Throws Error (input), naming `path`, where a grid cannot be that of a scan: voxels smaller than an atom
/// (1e-7 mm) or larger than a kilometre (1e6 mm), or a place more than a thousand kilometres away (1e9 mm).
/// Such numbers are damage, and beyond them coordinates lose their digits.
inline void requirePlausible(const std::filesystem::path& path, const Grid& grid) {
  char text[160];
  for (int axis = 0; axis < 3; ++axis)
    if (!(grid.spacingMm[axis] >= 1e-7) || !(grid.spacingMm[axis] <= 1e6)) {
      std::snprintf(text, sizeof text,
                    "its voxel spacing of %g mm is damaged; give the true one with --spacing X,Y,Z.",
                    grid.spacingMm[axis]);
      throw Error(Error::Kind::input, "Cannot read " + path.string() + ": " + text);
    }
  const double away = glm::length(grid.originMm);
  if (!(away <= 1e9)) {
    std::snprintf(text, sizeof text, "its header places it %g mm away, which is damage; export it again.",
                  away);
    throw Error(Error::Kind::input, "Cannot read " + path.string() + ": " + text);
  }
}

} // namespace limn
