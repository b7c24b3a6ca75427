// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/surfaces/SurfaceMesh.h"

#include <cstddef>

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

} // namespace limn
