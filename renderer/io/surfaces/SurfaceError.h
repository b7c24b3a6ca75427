// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "io/surfaces/SurfaceMesh.h"

#include <cstddef>
#include <optional>

namespace limn {

/// Distances in mm of so many points of one surface to another.
struct Distances {
  double largest = 0.0;
  double mean = 0.0;
  std::size_t points = 0;
  bool operator==(const Distances&) const = default;
};

/// How far a mesh and the boundary of its solid lie apart: their Hausdorff distance as far as points tell.
struct SurfaceError {
  Distances ofMesh;    ///< from points of the mesh to the boundary
  Distances ofSurface; ///< from points of the boundary to the mesh
  double largest() const { return std::max(ofMesh.largest, ofSurface.largest); }
  bool operator==(const SurfaceError&) const = default;
};

/// How many points are tried each way.
inline constexpr std::size_t pointsTried = 200'000;

/// The way in mm from a point to where the boundary is crossed, first along the normal and against it, then
/// in the directions of a cube's corners, edges and faces; nothing where there is no boundary within a few
/// voxels. It is as long as the distance or longer, because nearer places may lie between those directions.
std::optional<glm::dvec3> wayToBoundary(const Solid& solid, const glm::dvec3& pointMm,
                                        const glm::dvec3& normal);

/// Points of the boundary, evenly spread: those of a mesh of all its cells, moved onto it along their
/// normals. The seed is fixed. Throws Cancelled.
std::vector<glm::dvec3> boundaryPoints(const Solid& solid, const SurfaceMesh& full, const Progress& progress);

/// Both distances. From the mesh they are measured along its normals to where the trilinear field itself
/// crosses the isovalue (or region or crop end), and so never smaller than the distance. Throws Cancelled.
SurfaceError measuredError(const Solid& solid, const SurfaceMesh& mesh,
                           const std::vector<glm::dvec3>& boundary, const Progress& progress);

} // namespace limn
