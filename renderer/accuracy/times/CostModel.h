// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/times/Timing.h"

#include <glm/glm.hpp>

#include <functional>
#include <optional>

namespace limn {

/// What opening and drawing a volume of one size cost.
struct ScaleRow {
  int edge = 0;        ///< voxels along each axis
  double voxelsMb = 0; ///< 10⁶ bytes, as they are stored
  FrameCost opened;    ///< from the file to the volume, the same for all renderers of a size
  double openedMb = 0; ///< the most memory that it took
  BenchRow drawn;      ///< by one renderer
};

/// One picture drawn in bricks, counted rather than timed: what each rank of `limn-mpi` would do.
struct BrickRow {
  int edge = 0; ///< voxels along each axis
  int bricks = 0;
  glm::ivec2 size{0};       ///< of the picture, pixels
  double samples = 0.0;     ///< of all bricks together, those stepped over included
  double mostSamples = 0.0; ///< of the brick that has most to do
  double cpuMs = 0.0;       ///< of all bricks together, for the picture alone
  double mostCpuMs = 0.0;   ///< of the brick that took longest
  double mostKeptMb = 0.0;  ///< beside its voxels, of the brick that keeps most, 10⁶ bytes
  double reducedMb = 0.0;   ///< sent by all ranks together to make one picture of theirs, 10⁶ bytes
};

/// How unevenly the work is shared out: that of the busiest brick over the mean, ≥ 1.
double imbalanceOf(const BrickRow& row);

/// A figure's growth with the number of voxels: p of "voxels to the power of p", between the two largest
/// sizes that one program was measured at. Absent where there are not two, or a figure is 0.
std::optional<double> growthOf(const std::vector<ScaleRow>& rows, const std::string& program,
                               const std::function<double(const ScaleRow&)>& figureOf);

/// What measuring tells of any size: rates and shares that do not depend on it.
struct CostFacts {
  double samplesPerCpuSecond = 0.0; ///< of one core
  double samplesPerPixelEdge = 0.0; ///< samples of a picture over its pixels and the voxels along an edge
  double keptBytesPerVoxel = 0.0;   ///< beside the voxels
  double imbalance = 1.0;           ///< of the most bricks measured
};

/// From the largest volume, in the most bricks. `rows` is not empty.
CostFacts costFacts(const std::vector<BrickRow>& rows);

/// What is supposed of nodes that nobody here has; every figure is said where it is used.
struct SupposedNodes {
  double cores = 16;
  double linkBytesPerSecond = 10e9; ///< between two nodes
  double diskBytesPerSecond = 1e9;  ///< of each node
  double bytesPerVoxel = 2;
};

/// One picture of one large volume on so many nodes.
struct ManyNodes {
  double nodes = 1;
  double voxelsEach = 0.0;
  double voxelGbEach = 0.0; ///< mapped, 10⁹ bytes
  double keptGbEach = 0.0;  ///< beside the voxels
  double readSeconds = 0.0; ///< of each node's voxels, once
  double marchMs = 0.0;     ///< of the busiest node
  double messageMb = 0.0;   ///< one picture of partial results
  double movedGb = 0.0;     ///< of all nodes for one picture
  double compositeMs = 0.0; ///< along the tree's longest branch
};

/// What one picture of `size` pixels of a volume of so many voxels would cost on `nodes` ≥ 1 of those
/// supposed, in as many bricks as nodes.
ManyNodes onManyNodes(const CostFacts& facts, const SupposedNodes& supposed, double voxels,
                      const glm::ivec2& size, double nodes);

/// The number of nodes, a power of 2, with which a picture is made soonest: from there on each doubling adds
/// more to putting the parts together than it takes from marching.
double mostUsefulNodes(const CostFacts& facts, const SupposedNodes& supposed, double voxels,
                       const glm::ivec2& size);

} // namespace limn
