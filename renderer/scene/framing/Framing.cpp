// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/framing/Framing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

// From an anchor in world space to the eight corners of a box.
std::array<glm::dvec3, 8> cornersFrom(const glm::dvec3& anchor, const Grid& grid, const IndexBox& box) {
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 index = glm::mix(box.lower, box.upper, glm::bvec3(i & 1, i & 2, i & 4));
    corners[static_cast<std::size_t>(i)] = indexToWorld(grid, index + centreIndex(grid)) - anchor;
  }
  return corners;
}

glm::dvec3 centreOf(const Grid& grid, const IndexBox& box) {
  return indexToWorld(grid, 0.5 * (box.lower + box.upper) + centreIndex(grid));
}

} // namespace

Camera framed(const Camera& camera, const Grid& grid, const IndexBox& box, double aspect) {
  const CameraBasis basis = basisOf(camera);
  Camera placed = camera;
  placed.target = centreOf(grid, box);
  const double slope = halfHeight(camera) * framedShare;
  double distance = 0.0;
  double halfHeightMm = 0.0;
  for (const glm::dvec3& corner : cornersFrom(placed.target, grid, box)) {
    const double high =
        std::max(std::abs(glm::dot(corner, basis.up)), std::abs(glm::dot(corner, basis.right)) / aspect);
    // A corner nearer to the eye than the centre needs more distance.
    distance = std::max(distance, high / slope - glm::dot(corner, basis.forward));
    halfHeightMm = std::max(halfHeightMm, high);
  }
  if (camera.projection == Camera::Projection::orthographic) {
    placed.heightMm = 2.0 * halfHeightMm / framedShare;
    distance = std::max(boxDiagonalMm(grid), glm::length(camera.target - camera.position));
  }
  placed.position = placed.target - basis.forward * distance;
  placed.up = basis.up;
  return placed;
}

Camera framedCamera(const Scene& scene, double aspect, const Effort& effort) {
  return framed(scene.camera, scene.volume->grid(), visibleBox(scene, effort), aspect);
}

Camera framedView(const Scene& scene, StandardView view, double aspect, const Effort& effort) {
  const Grid& grid = scene.volume->grid();
  return framed(standardView(scene.camera, grid, view), grid, visibleBox(scene, effort), aspect);
}

Camera refitted(const Camera& camera, const Grid& grid, const IndexBox& box, double aspectBefore,
                double aspect) {
  const Camera before = framed(camera, grid, box, aspectBefore);
  const Camera after = framed(camera, grid, box, aspect);
  Camera placed = camera;
  if (camera.projection == Camera::Projection::orthographic)
    placed.heightMm *= after.heightMm / before.heightMm;
  else
    placed.position =
        camera.target + (camera.position - camera.target) * (glm::length(after.position - after.target) /
                                                             glm::length(before.position - before.target));
  return placed;
}

bool isFramed(const Camera& camera, const Grid& grid, const IndexBox& box, double aspect) {
  const Camera fit = framed(camera, grid, box, aspect);
  const double allowed = 1e-6 * boxDiagonalMm(grid);
  const bool isAsHigh = camera.projection == Camera::Projection::perspective ||
                        std::abs(camera.heightMm - fit.heightMm) <= allowed;
  return isAsHigh && glm::distance(camera.target, fit.target) <= allowed &&
         glm::distance(camera.position, fit.position) <= allowed;
}

} // namespace limn
