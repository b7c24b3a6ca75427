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

/// Axes of which the third is `axis`, a unit vector; columns.
glm::dmat3 axesAround(const glm::dvec3& axis);

/// Directions about the third axis, each from a point of the unit square: evenly over those within an angle
/// of it, over the half sphere by the cosine, and evenly over the whole sphere.
glm::dvec3 directionInCone(const glm::dvec2& point, double angleDeg);
glm::dvec3 directionByCosine(const glm::dvec2& point);
glm::dvec3 directionOnSphere(const glm::dvec2& point);

} // namespace limn
