// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Region.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace limn {

/// The place in the list of labels of the voxel that is nearest to a continuous voxel index, as the
/// segmentation has it, also where it was cut away by hand. Nothing where no segmentation is open or the
/// place lies outside the grid.
std::optional<std::size_t> voxelLabelAt(const Region& region, const glm::dvec3& index);

/// The name of that label; empty where there is none, and of the background.
std::string labelNameAt(const Region& region, const glm::dvec3& index);

/// The curve of its own by which the nearest voxel is shown: that of a piece that was picked there, else of
/// its label; null where neither has one.
const TransferFunction* ownLookAt(const Region& region, const glm::dvec3& index);

} // namespace limn
