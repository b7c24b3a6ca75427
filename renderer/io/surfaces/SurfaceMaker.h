// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "io/surfaces/SurfaceError.h"
#include "io/surfaces/SurfaceMesh.h"
#include "scene/Scene.h"

#include <cstddef>
#include <optional>

namespace limn {

/// The parts of a closed mesh that hang together, hollows within them among the parts.
struct SurfaceParts {
  std::vector<std::uint32_t> ofTriangle; ///< the part of each triangle
  std::vector<double> enclosedMm3;       ///< of each part; negative where it bounds a hollow
};

/// Triangles that share a point, by its index, belong to one part. Of parts with holes the volumes mean
/// nothing.
SurfaceParts partsOf(const SurfaceMesh& mesh);

/// What was left out because it was small.
struct DroppedParts {
  std::size_t parts = 0;
  std::size_t hollows = 0;  ///< that are filled therefore
  double enclosedMm3 = 0.0; ///< by the parts that are no hollows
};

/// For each triangle whether its part encloses at least so much, 1 or 0.
std::vector<std::uint8_t> largeParts(const SurfaceParts& parts, double leastMm3, DroppedParts& dropped);

/// How a surface is made.
struct SurfaceOrder {
  double isovalue = 300.0;
  bool isClosed = true;         ///< where crop, volume or kept region cut, flat faces close the holes
  double smallestPartMm3 = 0.0; ///< parts that enclose less are left out, hollows filled; 0: all stay
  double toleranceMm = 0.0;     ///< triangles are taken away as far as this distance allows; 0: none
  int cells =
      1; ///< along each axis from a voxel to the next, 1..mostCells: more follow the field more closely
  std::optional<double> memoryBytes; ///< that may be taken; absent: nobody knows
};

/// The most SurfaceOrder::cells; triangles grow with the square.
inline constexpr int mostCells = 8;

/// What a surface would be.
struct SurfaceEstimate {
  std::uint64_t triangles = 0; ///< before any are taken away
  double bytes = 0.0;          ///< of memory that making it takes beside the volume
};

/// A surface and what is known of it.
struct MadeSurface {
  SurfaceOrder order;
  SurfaceMesh mesh;
  std::size_t trianglesBefore = 0; ///< before any were taken away
  std::size_t parts = 0;           ///< that are left, without hollows
  DroppedParts dropped;
  EdgeCensus edges;
  double enclosedMm3 = 0.0; ///< where it is watertight
  SurfaceError error;
};

/// How large the surface of a scene would be. Costs a pass over the voxels of the crop. Throws Error (input)
/// where the isovalue lies outside the volume's range, or nothing of crop and kept region reaches it;
/// Cancelled.
SurfaceEstimate estimatedSurface(const Scene& scene, const SurfaceOrder& order,
                                 const Progress& progress = {});

/// Makes the isosurface of the scene's volume within its crop and kept region, and measures it. Throws as
/// estimatedSurface does, before it begins.
MadeSurface makeSurface(const Scene& scene, const SurfaceOrder& order, const Progress& progress = {});

} // namespace limn
