// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/basics/Room.h"
#include "scene/function/PiecewiseTable.h"
#include "scene/regions/BlockLooks.h"
#include "scene/regions/BlockWeights.h"
#include "scene/steps/BlockRanges.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

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

/// What may show in a picture: scalars that the transfer function makes opaque, and the surface of one scalar
/// (normalised as the texels are), in front of all at or above it. Either may be absent. Nothing shows of
/// blocks of which a region keeps nothing.
struct Visibility {
  const PiecewiseTable* function = nullptr;
  std::optional<float> isovalue;
  const BlockWeights* weights = nullptr; ///< of each block, x fastest; empty: all is kept
  /// Where labels have looks of their own: the functions of all looks in the place of `function`, and which
  /// of them each block has, x fastest.
  const std::vector<PiecewiseTable>* looks = nullptr;
  const BlockLooks* blockLooks = nullptr;
};

/// A box of blocks, half open; empty where nothing may show.
struct BlockBox {
  glm::ivec3 lower{0};
  glm::ivec3 upper{0};
  bool operator==(const BlockBox&) const = default;
};

/// Where nothing shows.
struct EmptySpaceMap {
  /// For each block the Chebyshev distance, in blocks, to the nearest in which something may show: 0 there,
  /// at most 255. All blocks nearer than it are empty.
  BlockDistances distances;
  double emptyShare = 0.0; ///< of the blocks
  BlockBox visible;        ///< the smallest box that holds every block of distance 0
};

/// Makes the map of blocks anew, where it lies. Throws Cancelled.
void mapEmptySpace(const BlockRanges& ranges, const Visibility& visibility, EmptySpaceMap& map,
                   const Effort& effort = {});

} // namespace limn
