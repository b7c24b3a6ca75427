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

} // namespace limn
