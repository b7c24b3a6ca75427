// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Room.h"
#include "scene/function/FunctionDetail.h"
#include "scene/regions/BlockLooks.h"
#include "scene/regions/BlockWeights.h"
#include "scene/volume/Volume.h"

#include <cstdint>
#include <vector>

namespace limn {

/// Cells between voxel centres along each edge of a block of facts.
inline constexpr int factCells = 4;

/// What is known of the field in one block, whatever the transfer function.
struct FieldFacts {
  ValueRange range;           ///< of the voxels on and in it
  double steepestPerMm = 0.0; ///< a bound of the change along any direction, value/mm
  double bendPerMm2 = 0.0;    ///< the largest change of the slope from voxel to voxel, value/mm²
  bool operator==(const FieldFacts&) const = default;
};

/// The field in blocks of 4³ cells between voxel centres; neighbours share the voxels on their common face.
/// The outermost blocks also own the half voxel before the volume's end, where the field is constant.
struct BlockFacts {
  glm::ivec3 blocks{0};
  RoomVector<FieldFacts> facts; ///< x fastest, in the volume's room
  ValueRange range;             ///< of all
  double commonPerMm = 0.0;     ///< what the field commonly changes by at most, value/mm (steepness)
};

/// One pass over the volume: keep the result while the volume stays. Throws Cancelled.
BlockFacts blockFacts(const Volume& volume, const Effort& effort = {});

/// With which steps to sample one block, as rungs (LocalSteps).
struct StepRungs {
  bool isEmpty = true;        ///< the transfer function shows nothing of it
  std::int8_t plain = 0;      ///< where the fineness is 0; the fineness adds to it
  std::uint8_t resolving = 0; ///< at least this, whatever the fineness: or a band of the function is missed
  bool operator==(const StepRungs&) const = default;
};

/// The rungs of every block under one transfer function.
struct BlockSteps {
  glm::ivec3 blocks{0};
  RoomVector<StepRungs> rungs;  ///< x fastest
  bool resolvesFunction = true; ///< false: a band of the function is narrower than the finest step can tell
};

/// The peaks and valleys of a transfer function that steps must resolve: those that show, measured by what
/// the smallest spacing absorbs.
std::vector<FunctionBand> bandsToResolve(const TransferFunction& function, double smallestSpacingMm);

/// From the facts of each block: its step is D^(-1/3) smallest spacings, which shares out the samples best
/// where a step h errs by D h³, and D is the largest extinction that the function has over the block's
/// values, times the largest bend of the field, in units of the smallest spacing and of what the field
/// commonly changes over it. And a peak or valley of the function that the block's values reach gets two
/// samples at least where the field is steepest: an estimate from finer pictures cannot see what no sample
/// has met. Where a kept region ends (`weights`; none: all is kept) the extinction bends as a field does that
/// changes by all that is common from voxel to voxel, and every voxel gets two samples. Throws Cancelled.
BlockSteps blockSteps(const BlockFacts& facts, const TransferFunction& function, double smallestSpacingMm,
                      const BlockWeights& weights = {}, const Effort& effort = {});

/// The same where labels have looks of their own: of `functions`, the scene's own first, each block follows
/// those that `looks` says its voxels have; where they are several the extinction bends as at a region's end.
BlockSteps blockSteps(const BlockFacts& facts, const std::vector<TransferFunction>& functions,
                      const BlockLooks& looks, double smallestSpacingMm, const BlockWeights& weights = {},
                      const Effort& effort = {});

/// The weights of a region in blocks of facts; none where all is kept. Throws Cancelled.
BlockWeights factWeights(const Region& region, const BlockFacts& facts, const Effort& effort = {});

/// The rung with which a block is entered.
int rungIn(const StepRungs& block, double fineness, double transmittance);

} // namespace limn
