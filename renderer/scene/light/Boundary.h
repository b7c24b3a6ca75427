// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/StableMath.h"
#include "scene/light/Shading.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace limn {

/// The normalised gradient modulus r, 0..1, after its curve (DEFINITION section 2).
inline double afterCurve(const GradientCurve& curve, double r) {
  switch (curve.type) {
  case GradientCurve::Type::linear:
    return r;
  case GradientCurve::Type::gamma:
    return gammaCurve(r, curve.parameter);
  case GradientCurve::Type::log:
    return logCurve(r, curve.parameter);
  }
  return r;
}

/// The outward normal of the cut face within `depth` of a place, otherwise `normal` (DEFINITION section 7).
/// `lower` and `upper` are the planes of the faces, in voxels as the place is, `spacing` the length of a
/// voxel in units of `depth`. Of two opposite faces that are as near as rounding can tell, the one through
/// which a ray along `direction` enters.
template <class Real>
glm::vec<3, Real> normalNearCut(const glm::vec<3, Real>& lower, const glm::vec<3, Real>& upper,
                                const glm::vec<3, Real>& spacing, Real depth, const glm::vec<3, Real>& place,
                                const glm::vec<3, Real>& direction, const glm::vec<3, Real>& normal) {
  Real nearest = depth;
  glm::vec<3, Real> chosen = normal;
  for (int axis = 2; axis >= 0; --axis) {
    const Real fromLower = (place[axis] - lower[axis]) * spacing[axis];
    const Real fromUpper = (upper[axis] - place[axis]) * spacing[axis];
    if (std::min(fromLower, fromUpper) > nearest)
      continue;
    nearest = std::min(fromLower, fromUpper);
    chosen = glm::vec<3, Real>(Real(0));
    const bool isTie = std::abs(fromUpper - fromLower) <= Real(1e-3) * depth;
    const bool isLower = isTie ? direction[axis] > Real(0) : fromLower < fromUpper;
    chosen[axis] = isLower ? Real(-1) : Real(1);
  }
  return chosen;
}

} // namespace limn
