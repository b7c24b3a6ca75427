// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Grid.h"

#include <filesystem>

namespace limn::test {

enum class BallKind {
  unknownOrientation, ///< brightness that falls from the middle, in a file that tells no sides
  labels              ///< four shells with names and colours
};

/// Writes a ball of 32³ voxels in NRRD, as large as the box of `grid` where there is one.
void writeBall(const std::filesystem::path& path, const Grid& grid, BallKind kind);

} // namespace limn::test
