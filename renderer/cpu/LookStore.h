// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/rays/PictureTerms.h"
#include "scene/LabelLooks.h"
#include "scene/basics/Effort.h"
#include "scene/regions/BlockLooks.h"
#include "scene/steps/EmptySpace.h"

#include <functional>
#include <memory>
#include <vector>

namespace limn::cpu {

/// The looks of labels as rays read them; empty where no label has one that shows.
class LookStore {
public:
  /// Of the scene's volume, the looks of blocks in `box`. What it makes lies in the volume's room. Throws
  /// Cancelled; what Room does.
  void update(const Scene& scene, const BlockBox& box, const Effort& effort);

  bool isEmpty() const { return !m_looks.areAny(); }

  /// Points into this; `unitsPer(unit distance)` tells how many of one are in a length.
  LookTerms terms(const std::function<float(double)>& unitsPer) const;

  /// Of every look, the scene's own first, and which of them blocks have.
  const std::vector<PiecewiseTable>& tables() const { return m_tables; }
  const BlockLooks& blocks() const { return m_blocks; }

  /// What it takes beside the region, bytes.
  std::size_t ownBytes() const {
    return m_voxels.size() + m_cells.size() + m_blocks.size() * sizeof(LookBits);
  }

private:
  void tabulate(const ValueRange& range);
  void findVoxels(const LabelMap& labels, const std::shared_ptr<Room>& room, const Effort& effort);

  std::shared_ptr<const LabelMap> m_labels;
  std::shared_ptr<const Volume> m_volume;
  LabelLooks m_looks;
  BlockBox m_box;
  RoomVector<std::uint8_t> m_voxels; // the look of each
  RoomVector<std::uint8_t> m_cells;  // and of each cell
  BlockLooks m_blocks;
  std::vector<PiecewiseTable> m_tables;
  std::vector<FewSegments> m_segments;
  PiecewiseTable m_union;
  FewSegments m_unionSegments;
};

} // namespace limn::cpu
