// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/StandIn.h"
#include "scene/volume/Pyramid.h"

#include <optional>
#include <vector>

namespace limn::cpu {

/// Scenes of fewer voxels, in memory, that stand in for those of a volume which does not lie there.
class StandIns {
public:
  /// Voxels of at most so many bytes for each level; one voxel in any case.
  explicit StandIns(std::uint64_t mostBytes) : m_mostBytes(mostBytes) {}

  /// Makes those of a volume, and forgets the last one's; none where it lies in memory. False where they are
  /// there. Throws Cancelled, and is then without any.
  bool makeReady(const std::shared_ptr<const Volume>& volume, const Effort& effort);

  /// Of a scene that is to be drawn in `size` pixels: of the levels whose voxels are no larger than a pixel
  /// in the middle of the volume the coarsest, or the finest. Absent where the volume is not the one made
  /// ready.
  std::optional<StandIn> of(const Scene& scene, const glm::ivec2& size);

  const std::vector<CoarseVolume>& levels() const { return m_levels; }

private:
  const Region& kept(const Region& keep, int reduction, std::size_t level);

  struct Kept {
    Region whole, coarse;
  };

  std::uint64_t m_mostBytes;
  std::shared_ptr<const Volume> m_whole;
  std::vector<CoarseVolume> m_levels;
  std::vector<Kept> m_kept; // what was kept last, of each level
};

} // namespace limn::cpu
