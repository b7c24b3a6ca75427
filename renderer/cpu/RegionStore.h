// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"
#include "scene/regions/BlockWeights.h"

namespace limn::cpu {

/// The weights of a kept region as rays read them. Keeps the region; where its labels are bytes that stand
/// for their weights, as those of a body do, they are not copied.
class RegionStore {
public:
  /// Throws Cancelled.
  void update(const Region& region, const glm::ivec3& blocks, const Effort& effort);

  const VoxelSource& source() const { return m_source; }

  /// Of the blocks in which rays step over what is empty; none where all is kept.
  const std::vector<BlockWeight>& blocks() const { return m_blocks; }

  /// What it takes beside the region, bytes.
  std::size_t ownBytes() const { return m_shares.size() * sizeof(std::uint16_t) + m_blocks.size(); }

private:
  Region m_region;
  std::vector<std::uint16_t> m_shares;
  VoxelSource m_source;
  std::vector<BlockWeight> m_blocks;
};

} // namespace limn::cpu
