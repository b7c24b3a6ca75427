// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "io/surfaces/SurfaceLattice.h"
#include "io/surfaces/SurfaceMesh.h"

namespace limn {

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
