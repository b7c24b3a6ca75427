// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Grid.h"

#include <glm/glm.hpp>

namespace limn {

/// From where on what a light path meets counts, mm: one and a half of the smallest spacings, so that a
/// surface does not shade itself (DEFINITION section 11).
double lightOffsetMm(const Grid& grid);

/// Point n of a sequence in the unit square of which every beginning is spread evenly: multiples of the
/// inverse of the plastic number and of its square (M. Roberts, The unreasonable effectiveness of quasirandom
/// sequences, 2018).
glm::dvec2 spreadPoint(int n);

/// Point n of a lattice of `count` in the unit square, which all together are spread more evenly than as many
/// of the sequence: each has a row of its own, and columns follow the golden ratio.
glm::dvec2 latticePoint(int n, int count);

/// Axes of which the third is `axis`, a unit vector; columns.
template <class T>
glm::mat<3, 3, T> axesAround(const glm::vec<3, T>& axis) {
  using V = glm::vec<3, T>;
  const V size = glm::abs(axis);
  const V aside = size.x <= size.y && size.x <= size.z ? V(T(1), T(0), T(0))
                  : size.y <= size.z                   ? V(T(0), T(1), T(0))
                                                       : V(T(0), T(0), T(1));
  const V first = glm::normalize(glm::cross(aside, axis));
  return {first, glm::cross(axis, first), axis};
}

/// Directions about the third axis, each from a point of the unit square: evenly over those within an angle
/// of it, over the half sphere by the cosine, and evenly over the whole sphere.
glm::dvec3 directionInCone(const glm::dvec2& point, double angleDeg);
glm::dvec3 directionByCosine(const glm::dvec2& point);
glm::dvec3 directionOnSphere(const glm::dvec2& point);

} // namespace limn
