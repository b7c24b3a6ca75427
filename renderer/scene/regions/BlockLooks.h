// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/basics/Room.h"
#include "scene/regions/BlockWeights.h"
#include "scene/regions/Region.h"

#include <cstdint>
#include <vector>

namespace limn {

/// A set of looks, a bit for each: the scene's own in the lowest.
using LookBits = std::uint64_t;
static_assert(mostLooks < 64);

/// Which looks the voxels of each block have, x fastest.
using BlockLooks = RoomVector<LookBits>;

/// Of each block, where `lookOf` says the look of each label by its place in the list; in the room given.
/// As of weights, one more voxel on each side counts. Throws Cancelled; what Room does.
BlockLooks blockLooks(const LabelMap& labels, const std::vector<std::uint8_t>& lookOf, const BlockGrid& grid,
                      const Effort& effort = {}, const std::shared_ptr<Room>& room = {});

/// The look of each voxel, x fastest, by that of its label. Throws Cancelled; what Room does.
RoomVector<std::uint8_t> looksOfVoxels(const LabelMap& labels, const std::vector<std::uint8_t>& lookOf,
                                       const Effort& effort = {}, const std::shared_ptr<Room>& room = {});

/// Where voxels of several looks meet.
inline constexpr std::uint8_t severalLooks = 255;

/// For each voxel the look of the cell that goes on from it, where all of its eight voxels have the same,
/// otherwise severalLooks; beyond the last voxel of an axis that one counts again. Throws as above.
RoomVector<std::uint8_t> cellLooks(const glm::ivec3& dims, const RoomVector<std::uint8_t>& looks,
                                   const Effort& effort = {}, const std::shared_ptr<Room>& room = {});

} // namespace limn
