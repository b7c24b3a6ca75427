// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/surfaces/Solid.h"
#include "io/surfaces/SurfaceMesh.h"

namespace limn {

/// The mesh with a normal for each point: -g/|g| of the field's gradient (DEFINITION section 2) where the
/// point lies on the isosurface; on faces that close a cut, and where there is no gradient, that of the
/// triangles around it.
SurfaceMesh withNormals(SurfaceMesh mesh, const Solid& solid, const Effort& effort = {});

} // namespace limn
