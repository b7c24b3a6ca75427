// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/GlObjects.h"
#include "glsl/textures/VolumeTexture.h"
#include "scene/LabelLooks.h"
#include "scene/function/PiecewiseTable.h"
#include "scene/regions/BlockLooks.h"

#include <memory>
#include <optional>
#include <vector>

namespace limn {

/// The looks of labels on the graphics card beside the texels of a volume; none where no label has one that
/// shows.
class LookTextures {
public:
  /// Uploads what differs from the scene before, beside the same volume's texture; changes texture bindings.
  /// Returns whether the functions are others. Throws Error (openGl) where the driver has no room for it.
  bool update(const Scene& scene, const VolumeTexture& volume);

  bool isEmpty() const { return !m_looks.areAny(); }

  /// Of every look, with common knots, the scene's own first; and which of them blocks have.
  const std::vector<PiecewiseTable>& tables() const { return m_tables; }
  const BlockLooks& ofBlocks() const { return m_ofBlocks; }

  /// Of all together: bins as those of each, the largest of their opacities; then the rows of each.
  const PiecewiseTable& together() const { return m_together; }

  /// From the segments of one look in `together` to those of the next.
  int segmentsPerLook() const { return m_segmentsPerLook; }

  /// The unit distance of each look, mm.
  const std::vector<double>& unitDistances() const { return m_unitDistances; }

  /// Of each cell its look + 1, or 0 where several meet; and of each the looks of four of its
  /// voxels. Names.
  unsigned cells() const { return m_cellTexture->name(); }
  unsigned labels() const { return m_labelTexture->name(); }

private:
  void tabulate(std::vector<TransferFunction> functions, const TransferFunction& own,
                const ValueRange& range);
  void uploadLabels(const Region& region, const std::vector<std::uint8_t>& lookOf,
                    const VolumeTexture& volume);

  LabelLooks m_looks;
  TransferFunction m_own; // the scene's
  std::shared_ptr<const LabelMap> m_labels;
  std::vector<PiecewiseTable> m_tables;
  PiecewiseTable m_together;
  int m_segmentsPerLook = 0;
  std::vector<double> m_unitDistances;
  BlockLooks m_ofBlocks;
  std::optional<GlTexture> m_cellTexture;
  std::optional<GlTexture> m_labelTexture;
};

} // namespace limn
