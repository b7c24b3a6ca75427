// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/PlaneGrid.h"
#include "scene/LabelLooks.h"
#include "scene/basics/Effort.h"
#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

#include <cstdint>
#include <span>
#include <vector>

namespace limn {

/// How a plane is read from a volume.
struct PlaneSampling {
  PlaneInterpolation interpolation = PlaneInterpolation::linear;
  Slab slab;
  bool operator==(const PlaneSampling&) const = default;
};

/// One number for each pixel of a plane, row by row; NaN where the volume is not.
struct PlaneImage {
  glm::ivec2 size{0};
  std::vector<double> values;

  double at(int x, int y) const { return values[static_cast<std::size_t>(y) * size.x + x]; }
};

/// The scalars on a plane (a multi-planar reformat): at every pixel the value at its centre, which is outside
/// where the volume's box, [-0.5, n-0.5) on each index axis, does not hold it; beyond the outermost voxel
/// centres the volume is clamped to its edge (DEFINITION section 1).
///
/// A slab of thickness d is sampled at the midpoints of equal parts of d across the plane, none thicker than
/// the voxels are along that direction, and its mean or maximum taken over the samples inside the volume.
///
/// Voxels are read as they are stored and everything is computed in double, without a copy of the volume.
/// Throws Cancelled.
PlaneImage reformatted(const Volume& volume, const PlaneGrid& plane, const PlaneSampling& sampling,
                       const Effort& effort = {});

/// The weights of a kept region on a plane of its volume, 0..1; of a slab those of the plane in its middle.
/// All 1 inside the volume where the region has no labels.
PlaneImage weightsOn(const Region& region, const Grid& volume, const PlaneGrid& plane,
                     PlaneInterpolation interpolation, const Effort& effort = {});

/// What of each pixel of a plane belongs to voxels of which look (DEFINITION section 10).
struct PlaneShares {
  struct Row {
    std::vector<std::uint32_t> ends; ///< of each pixel: behind the last of its shares
    std::vector<LookShare> shares;   ///< of pixel after pixel
  };
  glm::ivec2 size{0};
  std::vector<Row> rows; ///< from above

  /// Those of a pixel, which sum to 1; none outside the volume.
  std::span<const LookShare> at(int x, int y) const;
};

/// The shares of a region's looks on a plane of its volume: trilinear between voxels, or all the nearest
/// voxel's; of a slab those of the plane in its middle. `looks` has a number for each label of the region.
PlaneShares sharesOn(const Region& region, const LabelLooks& looks, const Grid& volume,
                     const PlaneGrid& plane, PlaneInterpolation interpolation, const Effort& effort = {});

} // namespace limn
