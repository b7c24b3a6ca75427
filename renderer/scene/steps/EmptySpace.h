// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/PiecewiseTable.h"

#include <cstdint>
#include <optional>

namespace limn {

/// Cells along each edge of a block.
inline constexpr int blockSize = 4;

/// By this many texels may a position computed in float lie on the wrong side of a block's face: a hundred
/// times what coordinates of a texture of 2048 texels lose to rounding.
inline constexpr float blockMargin = 1.0f / 128.0f;

/// The scalars that samples in each block of 4³ cells between texel centres can take. Neighbours share the
/// texels on their common face; the range stands for positions up to `blockMargin` texels beyond the block,
/// so that rounding there steps over nothing. The outermost blocks also own the half texel before the
/// volume's end, where the field is constant.
struct BlockRanges {
  glm::ivec3 blocks{0};
  std::vector<glm::vec2> ranges; ///< lowest and highest, x fastest
};

/// What may show in a picture: scalars that the transfer function makes opaque, and the surface of one scalar
/// (normalised as the texels are), in front of all at or above it. Either may be absent.
struct Visibility {
  const PiecewiseTable* function = nullptr;
  std::optional<float> isovalue;
};

/// The largest distance that is told of.
inline constexpr std::uint8_t farthestBlock = 255;

/// Lowers distances of `farthestBlock` to the Chebyshev distance to the nearest block of distance 0.
void spreadDistances(const glm::ivec3& blocks, std::vector<std::uint8_t>& distances);

/// For each block the Chebyshev distance, in blocks, to the nearest in which something may show: 0 there, at
/// most 255. All blocks nearer than it are empty.
std::vector<std::uint8_t> emptyDistances(const BlockRanges& ranges, const Visibility& visibility);

/// A box of blocks, half open; empty where nothing may show.
struct BlockBox {
  glm::ivec3 lower{0};
  glm::ivec3 upper{0};
};

/// The smallest box that holds every block of distance 0.
BlockBox visibleBlocks(const glm::ivec3& blocks, const std::vector<std::uint8_t>& distances);

} // namespace limn
