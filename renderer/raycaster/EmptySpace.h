// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raycaster/PiecewiseTable.h"
#include "raycaster/TextureVoxels.h"

#include <cstdint>
#include <optional>

namespace limn {

/// Texels along each edge of a block.
inline constexpr int blockSize = 4;

/// The scalars that samples in each block of 4³ texels can take. A block owns the positions from half a texel
/// before its first texel's centre to half a texel behind its last one's; its range holds a texel more on
/// either side, so that it stands for positions up to half a texel beyond it.
struct BlockRanges {
  glm::ivec3 blocks{0};
  std::vector<glm::vec2> ranges; ///< lowest and highest, x fastest
};

BlockRanges blockRanges(const TextureVoxels& voxels);

/// What may show in a picture: scalars that the transfer function makes opaque, and the surface of one scalar
/// (normalised as the texels are). Either may be absent.
struct Visibility {
  const PiecewiseTable* function = nullptr;
  std::optional<float> isovalue;
};

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
