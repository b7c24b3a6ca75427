// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/basics/Effort.h"

namespace limn {

/// Every voxel that lies within an ellipsoid around one of the set. `radii` are its half axes in voxels, each
/// ≥ 0. Beyond the grid lies nothing. An ellipsoid of more than 6 voxels is put together from equal smaller
/// ones, as a ball is the sum of two of half its radius; its edge is then off by less than a voxel each.
BitGrid dilated(const BitGrid& set, const glm::dvec3& radii, const Effort& effort);

/// Every voxel around which the whole ellipsoid belongs to the set; what lies beyond the grid counts as if it
/// did, so that a body that the border cuts is not eaten from there.
BitGrid eroded(const BitGrid& set, const glm::dvec3& radii, const Effort& effort);

/// Eroded, then dilated: without what is thinner than the ellipsoid.
BitGrid opened(const BitGrid& set, const glm::dvec3& radii, const Effort& effort);

/// Dilated, then eroded: with the gaps that are thinner than the ellipsoid.
BitGrid closed(const BitGrid& set, const glm::dvec3& radii, const Effort& effort);

} // namespace limn
