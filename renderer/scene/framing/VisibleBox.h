// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/steps/RayFrame.h"

#include <optional>
#include <tuple>

namespace limn {

/// From this opacity on a voxel counts as visible (DEFINITION section 8).
inline constexpr double visibleOpacity = 0.02;

/// The part of the volume that a picture is framed on, centred index: the smallest box around the voxels
/// within crop and kept region whose opacity under the curve, weighed by the region, is at least
/// `visibleOpacity` (or, where the projection shows a surface, whose value reaches the isovalue), one voxel
/// wider on each side, inside volume and crop. Where there is none, all that the crop leaves. Throws
/// Cancelled.
IndexBox visibleBox(const Scene& scene, const Effort& effort = {});

/// The smallest box of voxels around those within `within` that count so and that the volume holds; absent
/// where there is none. Throws Cancelled.
std::optional<VoxelBox> visibleVoxels(const Scene& scene, const VoxelBox& within, const Effort& effort = {});

/// What was found of a part of the voxels, and of two: in any order and grouping the same.
struct VisibleVoxels {
  std::optional<VoxelBox> box;
  auto fields() { return std::tie(box); }
};
VisibleVoxels joined(const VisibleVoxels& a, const VisibleVoxels& b);

/// Voxels of both boxes; an empty box where there is none.
VoxelBox intersection(const VoxelBox& a, const VoxelBox& b);

} // namespace limn
