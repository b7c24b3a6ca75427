// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/surfaces/SurfaceMesh.h"

#include <functional>

namespace limn {

/// The distances in mm from points to a mesh that has triangles (VTK's static cell locator). Throws
/// Cancelled.
std::vector<double> distancesTo(const SurfaceMesh& mesh, const std::vector<glm::dvec3>& points,
                                const Effort& effort);

} // namespace limn
