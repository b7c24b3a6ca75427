// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"
#include "scene/basics/Effort.h"
#include "scene/steps/EmptySpace.h"
#include "scene/volume/Volume.h"

#include <memory>

namespace limn::cpu {

/// The voxels on and in some blocks.
VoxelBox voxelsOf(const BlockBox& part, const glm::ivec3& dims);

/// A volume's voxels as rays read them, and the scalars that its blocks hold. Keeps the volume; copies it to
/// floats only where its type, or a range that is narrow beside its values, asks for it. What it makes lies
/// in the volume's room.
class VoxelStore {
public:
  /// Rays read the voxels of `part` alone, half open: no others are looked at, and of those that are copied
  /// the rest stays unset. A volume that holds a part
  /// of its voxels must hold those. Throws Error (input) where there are too many rows to count, before
  /// anything is copied; what Room does; Cancelled. `asFloats`: all types are copied to floats.
  VoxelStore(std::shared_ptr<const Volume> volume, const BlockBox& part, const Effort& effort,
             bool asFloats = false);

  const VoxelSource& source() const { return m_source; }

  /// Of the blocks of the part.
  const BlockRanges& blocks() const { return m_blocks; }
  const BlockBox& part() const { return m_part; }

  /// What it takes in memory beside the volume, bytes.
  std::size_t ownBytes() const;

private:
  std::shared_ptr<const Volume> m_volume;
  BlockBox m_part;
  RoomVector<float> m_floats;
  VoxelSource m_source;
  BlockRanges m_blocks;
};

} // namespace limn::cpu
