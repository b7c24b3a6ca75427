// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "io/surfaces/SurfaceMesh.h"

namespace limn {

/// The mesh with fewer triangles: edges are drawn together in the order of quadric errors, each only where
/// the boundary of the solid itself, not the mesh before, is met within `toleranceMm` > 0 on both sides of
/// the triangles that change, at points at most a voxel apart. The rims of holes stay. Neither do triangles
/// turn over nor do edges get a third triangle: what was watertight stays so. Normals are dropped. Throws
/// Cancelled.
SurfaceMesh decimated(const SurfaceMesh& mesh, const Solid& solid, double toleranceMm,
                      const Progress& progress);

} // namespace limn
