// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/PlaneGrid.h"

#include <algorithm>
#include <cmath>

namespace limn::test {

/// The plane of the patient through a place in the world that covers the volume's box, however that lies,
/// with the volume's smallest spacing. Where the grid's axes are the patient's and the place is a voxel's
/// centre, pixels are voxels.
inline PlaneGrid coveringPlane(const Grid& volume, PatientPlane plane, const glm::dvec3& throughMm) {
  PlaneGrid grid;
  grid.axes = axesOf(plane);
  grid.spacingMm = smallestSpacingMm(volume);
  const ReachMm across = reachAlong(volume, grid.axes.right);
  const ReachMm down = reachAlong(volume, grid.axes.down);
  // Rounding must not add a pixel.
  const auto pixelsFor = [&](const ReachMm& reach) {
    return std::max(1, static_cast<int>(std::ceil((reach.last - reach.first) / grid.spacingMm - 1e-6)));
  };
  grid.size = {pixelsFor(across), pixelsFor(down)};
  grid.originMm = (across.first + grid.spacingMm / 2.0) * grid.axes.right +
                  (down.first + grid.spacingMm / 2.0) * grid.axes.down +
                  glm::dot(throughMm, grid.axes.forward) * grid.axes.forward;
  return grid;
}

} // namespace limn::test
