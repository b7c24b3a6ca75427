// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace limn {

/// The corners of a convex polygon of the plane, counter-clockwise; empty where it has no area.
using ConvexPolygon = std::vector<glm::dvec2>;

/// The smallest convex polygon around points, without corners on its edges. Exact for whole numbers up to
/// 2²⁵.
ConvexPolygon convexHull(std::vector<glm::dvec2> points);

/// The part of a convex polygon inside a rectangle.
ConvexPolygon clipped(const ConvexPolygon& polygon, const glm::dvec2& lower, const glm::dvec2& upper);

} // namespace limn
