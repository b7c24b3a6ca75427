// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace limn {

/// Triangles in patient space LPS, millimetres, in the precision that files of meshes have.
struct SurfaceMesh {
  std::vector<glm::vec3> points;
  std::vector<glm::vec3> normals;    ///< of the points, unit length, out of the higher values; or none
  std::vector<glm::uvec3> triangles; ///< anticlockwise seen from the side of the lower values
  bool operator==(const SurfaceMesh&) const = default;
};

/// How the triangles hang together, points at the same place being one.
struct EdgeCensus {
  std::uint64_t edges = 0;
  std::uint64_t usedOnce = 0; ///< the rims of holes
  std::uint64_t usedOtherwise =
      0; ///< by more than two triangles, or by two that are turned against each other
  /// Every edge is used by exactly two triangles, once in each direction.
  bool isWatertight() const { return edges > 0 && usedOnce == 0 && usedOtherwise == 0; }
};

/// Counts the edges; a watertight mesh has none but those that two triangles share.
EdgeCensus edgesOf(const SurfaceMesh& mesh);

/// The volume that the triangles enclose, mm³: the sum of tetrahedra (divergence theorem). Of meshes with
/// holes it means nothing.
double enclosedMm3(const SurfaceMesh& mesh);

/// Twice the area times the normal of a triangle, mm².
glm::dvec3 areaVector(const SurfaceMesh& mesh, const glm::uvec3& triangle);

/// The triangles whose flag is set, and the points that they use. `flags` has one for each triangle.
SurfaceMesh onlyTriangles(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& flags);

} // namespace limn
