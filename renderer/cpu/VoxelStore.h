// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"
#include "scene/basics/Effort.h"
#include "scene/steps/BlockRanges.h"
#include "scene/volume/Volume.h"

#include <memory>

namespace limn::cpu {

/// A volume's voxels as rays read them, and the scalars that its blocks hold. Keeps the volume; copies it to
/// floats only where its type, or a range that is narrow beside its values, asks for it.
class VoxelStore {
public:
  /// Throws Error (input) where a slice takes more than 4 GiB, before anything is copied; Cancelled.
  VoxelStore(std::shared_ptr<const Volume> volume, const Effort& effort);

  const VoxelSource& source() const { return m_source; }
  const BlockRanges& blocks() const { return m_blocks; }

  /// What it takes beside the volume, bytes.
  std::size_t ownBytes() const;

private:
  std::shared_ptr<const Volume> m_volume;
  std::vector<float> m_floats;
  VoxelSource m_source;
  BlockRanges m_blocks;
};

} // namespace limn::cpu
