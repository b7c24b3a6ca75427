// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"
#include "scene/regions/BlockWeights.h"
#include "scene/steps/EmptySpace.h"

namespace limn::cpu {

/// The weights of a kept region as rays read them. Keeps the region; where its labels are bytes on whose
/// places the weights lie in a line, as those of a body or of a cut do, they are not copied.
class RegionStore {
public:
  /// The weights of the blocks of `box` are found. What it makes lies in the volume's room. Throws Cancelled;
  /// what Room does.
  void update(const Region& region, const BlockBox& box, const std::shared_ptr<Room>& room,
              const Effort& effort);

  const VoxelSource& source() const { return m_source; }

  /// Of the blocks in which rays step over what is empty; none where all is kept.
  const BlockWeights& blocks() const { return m_blocks; }

  /// For each of these blocks the distance to the nearest of which not all is kept (scene/steps/EmptySpace);
  /// none where all is, or where weights as rays read them are not 1 to the bit.
  const BlockDistances& whole() const { return m_whole; }

  /// What it takes beside the region, bytes.
  std::size_t ownBytes() const {
    return m_shares.size() * sizeof(std::uint16_t) + m_bytes.size() + m_blocks.size() + m_whole.size();
  }

private:
  void findWhole(const glm::ivec3& blocks, const Effort& effort);

  Region m_region;
  BlockBox m_box;
  RoomVector<std::uint16_t> m_shares;
  RoomVector<std::uint8_t> m_bytes;
  VoxelSource m_source;
  BlockWeights m_blocks;
  BlockDistances m_whole;
};

} // namespace limn::cpu
