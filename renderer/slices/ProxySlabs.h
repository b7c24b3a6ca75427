// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <vector>

namespace limn {

/// The corners of a convex polygon of the plane, counter-clockwise; empty where it has no area.
using ConvexPolygon = std::vector<glm::dvec2>;

/// The smallest convex polygon around points, without corners on its edges. Exact for whole numbers up to
/// 2²⁵.
ConvexPolygon convexHull(std::vector<glm::dvec2> points);

/// The part of a convex polygon inside a rectangle.
ConvexPolygon clipped(const ConvexPolygon& polygon, const glm::dvec2& lower, const glm::dvec2& upper);

/// Corners of proxy polygons lie on a grid of this many lines per pixel, which every rasteriser resolves
/// (OpenGL asks for 4 bits below the pixel): a convex polygon stays one, and its triangles never overlap.
inline constexpr double gridPerPixel = 16.0;

/// The volume between two view-aligned planes: depths in mm along the view, measured from the anchor plane of
/// RayFrame, and the polygon that covers its part of the box as the camera sees it, in pixels from the
/// picture's centre (y up). Every ray through a pixel's centre that meets that part meets the polygon.
struct ProxySlab {
  double nearMm = 0.0;
  double farMm = 0.0;
  ConvexPolygon polygon;
};

/// The slabs of a scene's cropped box from the nearest to the farthest, of equal thickness, at most one step:
/// the far plane of each is the near plane of the next. The very first plane and the very last lie far
/// outside: the box's faces end it there, and rounding a plane to float loses nothing. Slabs beside the
/// picture are left out; there are none behind the eye. At most `mostSamples` (DEFINITION section 7).
std::vector<ProxySlab> proxySlabs(const Scene& scene, const glm::ivec2& size);

/// How many slabs of one step the scene's box would need before that limit.
double slabsWanted(const Scene& scene, const glm::ivec2& size);

} // namespace limn
