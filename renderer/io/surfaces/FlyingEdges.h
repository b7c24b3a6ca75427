// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace limn {

/// Which triangles separate the marked places of a lattice from the others.
struct LatticeTriangles {
  /// Points, each in the middle of an edge of the lattice, in half steps: one coordinate is odd.
  std::vector<glm::ivec3> halves;
  std::vector<glm::uvec3> triangles; ///< anticlockwise seen from the places that are not marked
};

/// VTK's flying edges (W. Schroeder, R. Maynard, B. Geveci, "Flying Edges: A High-Performance Scalable
/// Isocontouring Algorithm", LDAV 2015). `marks` are 1 or 0, x fastest, at least two along each axis.
LatticeTriangles trianglesBetween(std::vector<std::uint8_t>& marks, const glm::ivec3& dims);

} // namespace limn
