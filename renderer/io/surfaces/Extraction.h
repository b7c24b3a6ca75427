// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "io/surfaces/SurfaceMesh.h"

#include <array>
#include <vector>

namespace limn {

/// Where the solid is asked along the axes of the grid, so that its boundary becomes triangles: at every
/// voxel centre inside the crop, and at the two planes where the crop, or the volume, ends. Along each axis
/// the field is linear between neighbours. One more layer at either end lies at the same place and outside:
/// between it and the last one, flat faces close what is cut.
class SurfaceLattice {
public:
  /// `cells` ≥ 1: so many along each axis from one voxel centre to the next. The field is the same; of finer
  /// cells the triangles follow it more closely.
  explicit SurfaceLattice(const Solid& solid, int cells = 1);

  const glm::ivec3& dims() const { return m_dims; }
  const Solid& solid() const { return *m_solid; }

  /// The voxel index of a place of the lattice.
  glm::dvec3 indexOf(const glm::ivec3& place) const {
    return {m_at[0][place.x], m_at[1][place.y], m_at[2][place.z]};
  }
  bool isOutside(int axis, int place) const { return place == 0 || place + 1 == m_dims[axis]; }

  /// Whether the solid contains the places of some layers, x fastest, 1 or 0.
  std::vector<std::uint8_t> marked(int firstLayer, int layers, const Effort& effort) const;

private:
  void markRow(int j, int k, std::uint8_t* out) const;

  const Solid* m_solid;
  int m_cells;
  std::array<std::vector<double>, 3> m_at;
  glm::ivec3 m_dims{0};
};

/// How many of the lattice's edges the surface crosses: as many points as its mesh has, or some more where
/// flat faces meet; there are about twice as many triangles. Costs a pass over the voxels of the crop.
std::uint64_t crossedEdges(const SurfaceLattice& lattice, const Effort& effort = {});

/// The boundary of a solid as triangles, closed.
struct ExtractedSurface {
  SurfaceMesh mesh;
  /// For each triangle whether it closes what crop, volume or kept region cut, 1 or 0.
  std::vector<std::uint8_t> isCut;
};

/// Every point lies where the boundary crosses an edge of the lattice, on the trilinear field itself; but
/// none nearer to a corner than 0.001 voxel, so that points stay apart. Works through the volume in slabs:
/// beside the mesh it takes a byte for each voxel of a few layers. Throws Cancelled.
ExtractedSurface extractedSurface(const SurfaceLattice& lattice, const Progress& progress);

} // namespace limn
