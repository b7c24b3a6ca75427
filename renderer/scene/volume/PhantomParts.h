// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace limn {

/// An ellipsoid of one tissue with axes along the world axes. Later parts cover earlier ones.
struct PhantomPart {
  glm::dvec3 centreMm;
  glm::dvec3 radiiMm;
  double hu;
  double edgeMm; ///< width over which the part fades in, measured along its shortest radius
};

/// The anatomy of the phantom, in painting order. LPS: +x left, +y posterior, +z superior.
std::vector<PhantomPart> phantomParts();

} // namespace limn
