// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/basics/Effort.h"
#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

#include <cstddef>
#include <vector>

namespace limn {

/// A region with its cuts made.
struct CutRegion {
  Region region;
  std::vector<std::size_t> taken; ///< how many voxels that were seen each of the cuts took; 0 where off
  std::size_t left = 0;           ///< how many are seen still
};

/// `region` with `cuts` in the place of its own, in their order (DEFINITION section 10): what they take away
/// is one label more, and so is each piece that they give a look. Where `cuts` only go on from the region's
/// own, work begins behind those. Voxels are read for pieces alone. Throws Error (input) where the labels
/// leave no number free for what is cut away or there are more looks than can be drawn; Cancelled.
CutRegion cutRegion(const Volume& volume, const Region& region, std::vector<Cut> cuts,
                    const Effort& effort = {});

/// Whether the labels of a region do not show its cuts, or show pieces that were found among other labels.
bool needsCutting(const Region& region);

/// Cuts that take the same voxels once these lie as `to` says, as `from` said before: a line that a mirror
/// turned over is drawn in the mirrored picture.
std::vector<Cut> cutsMoved(std::vector<Cut> cuts, const Grid& from, const Grid& to);

/// The voxels of a piece among those of `kept`, grown; empty where the voxel nearest to the seed is none of
/// them or lies outside the range. Throws Cancelled.
BitGrid pieceAmong(const BitGrid& kept, const Volume& volume, const ConnectedPiece& piece,
                   const Effort& effort = {});

/// The voxels to which a region leaves more than nothing. Throws Cancelled.
BitGrid keptVoxels(const Region& region, const Volume& volume, const Effort& effort = {});

/// The same region with what is seen of it besides `lit` faded to `weight`, 0..1: for the eye, as no file
/// says it. Throws as cutRegion.
Region lit(const Region& region, const BitGrid& lit, double weight, const Effort& effort = {});

/// Cuts that were `wanted` while there were those of `then`, where there are those of `now`: what was added
/// behind the former comes behind the latter; any others are wanted as they are.
std::vector<Cut> cutsOver(const std::vector<Cut>& now, const std::vector<Cut>& then,
                          const std::vector<Cut>& wanted);

/// Cuts that take the same voxels are alike without their names.
std::vector<Cut> withoutNames(std::vector<Cut> cuts);

} // namespace limn
