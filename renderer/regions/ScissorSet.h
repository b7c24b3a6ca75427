// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/basics/Effort.h"
#include "scene/regions/Cut.h"
#include "scene/volume/Grid.h"

#include <memory>

namespace limn {

/// Whether a closed line, which may cross itself, goes around a place (even-odd).
bool isInside(const std::vector<glm::dvec2>& polygon, const glm::dvec2& place);

/// Where a place is seen, in halves of the picture's height from its middle, y up (DEFINITION section 8);
/// nothing where it does not lie before the camera.
std::optional<glm::dvec2> placeInPicture(const Camera& camera, const glm::dvec3& worldMm);

/// How deep scissors reach that take what is seen inside their line, by how deep that lies at places spread
/// over it (mm along the rays, at least one): to the farthest, but not through a gap in what lies before.
/// Beyond a gap lies what a quarter of the places or fewer show after a jump of more than 10 mm and of more
/// than half of the depths before it.
double depthOfSeen(std::vector<double> depthsMm);

/// The voxels whose centres the scissors take away (DEFINITION section 10). A line of fewer than three
/// corners encloses nothing. Rows of voxels are straight lines in the picture, so each is cut at the edges of
/// the polygon, not voxel by voxel: a row costs as much as the polygon has corners. Throws Cancelled.
BitGrid takenBy(const Scissors& scissors, const Grid& grid, const std::shared_ptr<Room>& room = {},
                const Effort& effort = {});

} // namespace limn
