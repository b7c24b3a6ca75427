// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/steps/RayFrame.h"

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace limn {

/// From this opacity on a voxel counts as visible (DEFINITION section 8).
inline constexpr double visibleOpacity = 0.02;

/// Cubes of voxels along each side of a block.
inline constexpr int blockUnits = 8;

/// Which of 8 × 8 × 8 neighbouring units of a grid are visible; a unit is a cube of voxels, as a rule one.
struct VisibleBlock {
  glm::ivec3 place{0}; ///< of the block among blocks: its first voxel is blockUnits · unitVoxels · place
  std::uint32_t voxels = 0;                      ///< visible ones
  std::array<std::uint64_t, blockUnits> units{}; ///< unit (x, y, z) is bit 8y + x of word z
  bool operator==(const VisibleBlock&) const = default;
};

/// The voxels that a picture is framed on: one bit each where there are up to 2²⁸, so that 512 × 512 × 300
/// fill 12 MB at most. Of parts of a volume, joined in any order and grouping, the same as of the whole.
struct VisibleVoxels {
  int unitVoxels = 1;               ///< along each side of a unit, 1..8
  std::uint64_t voxels = 0;         ///< visible ones
  std::vector<VisibleBlock> blocks; ///< in which something is visible; by z, y and x of their places
  glm::ivec3 lower{0};              ///< the smallest box around them, empty where there are none
  glm::ivec3 upper{0};

  auto fields() { return std::tie(unitVoxels, voxels, blocks, lower, upper); }
  bool operator==(const VisibleVoxels&) const = default;
};

/// Of units of the same size.
VisibleVoxels joined(const VisibleVoxels& a, const VisibleVoxels& b);

/// The side of the units in which a box of voxels is described.
int unitVoxelsFor(const VoxelBox& box);

/// What a picture of the scene is framed on: the voxels within crop and kept region whose opacity under the
/// curve, weighed by the region, is at least `visibleOpacity` (or, where the projection shows a surface,
/// whose value reaches the isovalue). Where there is none, all that the crop leaves; never none. Blocks
/// within what is visible, which framing never asks for, are left out (withoutInner). Throws Cancelled.
VisibleVoxels visibleVoxels(const Scene& scene, const Effort& effort = {});

/// Those within a box that count so, from another opacity on if one is given, and that the volume holds, in
/// units of `unitVoxels`; maybe none. Throws Cancelled.
VisibleVoxels visibleWithin(const Scene& scene, const VoxelBox& box, int unitVoxels,
                            const Effort& effort = {}, double leastOpacity = visibleOpacity);

/// All voxels that a crop leaves, without inner blocks; where it leaves the centre of none, those nearest to
/// it. To half a voxel where they are more than 2²⁴.
VisibleVoxels allVoxelsOf(const Grid& grid, const CropBox& crop);

/// The box around what is visible, centred index, one voxel wider on each side, inside volume and crop; all
/// that the crop leaves where nothing is. Throws Cancelled.
IndexBox visibleBox(const Scene& scene, const Effort& effort = {});

/// Whether the crop takes nothing away that would be seen, be it as faint as the curve makes it: that lies a
/// voxel and more within the faces that cut. False of projections to which what is transparent adds as well
/// (minimum, average; maximum where it may hide what shows), and of a part of a volume. Throws Cancelled.
bool cropsOnlyUnseen(const Scene& scene, const Effort& effort = {});

/// Voxels of both boxes; an empty box where there is none.
VoxelBox intersection(const VoxelBox& a, const VoxelBox& b);

} // namespace limn
