// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/basics/Room.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace limn {

/// The largest distance that is told of.
inline constexpr std::uint8_t farthestBlock = 255;

/// A distance for each block, x fastest.
using BlockDistances = RoomVector<std::uint8_t>;

/// Lowers distances of `farthestBlock` to the Chebyshev distance to the nearest block of distance 0.
void spreadDistances(const glm::ivec3& blocks, BlockDistances& distances, const Effort& effort = {});

/// The two halves of it: within the planes z = `first` … `end`-1, each for itself, then from plane to plane,
/// which throws Cancelled.
void spreadWithinPlanes(const glm::ivec3& blocks, int first, int end, BlockDistances& distances);
void spreadAcrossPlanes(const glm::ivec3& blocks, BlockDistances& distances, const Effort& effort = {});

} // namespace limn
