// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/Camera.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

// The largest component is divided out first, so that neither tiny nor huge vectors lose their direction.
glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& fallback) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0) || !std::isfinite(largest))
    return fallback;
  return glm::normalize(v / largest);
}

glm::dvec3 axisLeastAligned(const glm::dvec3& direction) {
  const glm::dvec3 a = glm::abs(direction);
  if (a.z <= a.x && a.z <= a.y)
    return {0.0, 0.0, 1.0};
  return a.x <= a.y ? glm::dvec3{1.0, 0.0, 0.0} : glm::dvec3{0.0, 1.0, 0.0};
}

glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * glm::dot(axis, v) * (1.0 - std::cos(angle));
}

// A distance from which a sphere of the box's diagonal fills the picture of a 30° field of view with 10 % to
// spare; the same rule serves other fields of view.
double viewingDistance(const Grid& grid, double fovYDeg) {
  return 1.1 * boxDiagonalMm(grid) / 2.0 / std::sin(radians(fovYDeg / 2.0));
}

} // namespace

CameraBasis basisOf(const Camera& camera) {
  CameraBasis basis;
  basis.forward = unitOr(camera.target - camera.position, {0.0, 1.0, 0.0});
  const glm::dvec3 up = unitOr(camera.up, {0.0, 0.0, 1.0});
  glm::dvec3 right = glm::cross(basis.forward, up);
  if (glm::length(right) < 1e-6)
    right = glm::cross(basis.forward, axisLeastAligned(basis.forward));
  basis.right = glm::normalize(right);
  basis.up = glm::cross(basis.right, basis.forward);
  return basis;
}

double halfHeight(const Camera& camera) {
  return camera.projection == Camera::Projection::perspective ? std::tan(radians(camera.fovYDeg / 2.0))
                                                              : camera.heightMm / 2.0;
}

Ray rayThroughPixel(const Camera& camera, int x, int y, const glm::ivec2& size) {
  const CameraBasis basis = basisOf(camera);
  const double aspect = static_cast<double>(size.x) / size.y;
  const double u = (2.0 * (x + 0.5) / size.x - 1.0) * aspect * halfHeight(camera);
  const double v = (1.0 - 2.0 * (y + 0.5) / size.y) * halfHeight(camera);
  const glm::dvec3 offset = basis.right * u + basis.up * v;
  if (camera.projection == Camera::Projection::orthographic)
    return {camera.position + offset, basis.forward};
  return {camera.position, glm::normalize(basis.forward + offset)};
}

std::optional<Ray> rayThroughPlace(const Camera& camera, const glm::dvec3& worldMm) {
  const glm::dvec3 arm = worldMm - camera.position;
  if (camera.projection == Camera::Projection::orthographic) {
    const glm::dvec3 forward = basisOf(camera).forward;
    return Ray{worldMm - glm::dot(arm, forward) * forward, forward};
  }
  const double length = glm::length(arm);
  return length > 0.0 ? std::optional(Ray{camera.position, arm / length}) : std::nullopt;
}

Camera defaultCamera(const Grid& grid) {
  Camera camera;
  camera.heightMm = 1.1 * boxDiagonalMm(grid);
  return standardView(camera, grid, StandardView::anterior);
}

Camera standardView(const Camera& camera, const Grid& grid, StandardView view) {
  // LPS: +x is the patient's left, +y posterior, +z superior.
  struct Pose {
    glm::dvec3 from, up;
  };
  const auto pose = [view]() -> Pose {
    switch (view) {
    case StandardView::anterior:
      return {{0, -1, 0}, {0, 0, 1}};
    case StandardView::posterior:
      return {{0, 1, 0}, {0, 0, 1}};
    case StandardView::left:
      return {{1, 0, 0}, {0, 0, 1}};
    case StandardView::right:
      return {{-1, 0, 0}, {0, 0, 1}};
    case StandardView::superior:
      return {{0, 0, 1}, {0, -1, 0}};
    case StandardView::inferior:
      return {{0, 0, -1}, {0, -1, 0}};
    }
    assert(false);
    return {};
  }();
  Camera placed = camera;
  placed.target = boxCentreMm(grid);
  placed.position = placed.target + pose.from * viewingDistance(grid, camera.fovYDeg);
  placed.up = pose.up;
  if (camera.projection == Camera::Projection::orthographic)
    placed.heightMm = 1.1 * boxDiagonalMm(grid);
  return placed;
}

Camera orbited(const Camera& camera, double yaw, double pitch) {
  const CameraBasis basis = basisOf(camera);
  glm::dvec3 arm = camera.position - camera.target;
  arm = turned(arm, basis.up, yaw);
  const glm::dvec3 right = turned(basis.right, basis.up, yaw);
  Camera moved = camera;
  moved.position = camera.target + turned(arm, right, pitch);
  moved.up = turned(basis.up, right, pitch);
  return moved;
}

Camera rolled(const Camera& camera, double angle) {
  const CameraBasis basis = basisOf(camera);
  Camera moved = camera;
  moved.up = turned(basis.up, basis.forward, -angle);
  return moved;
}

Camera panned(const Camera& camera, double x, double y) {
  const CameraBasis basis = basisOf(camera);
  const double height = camera.projection == Camera::Projection::orthographic
                            ? camera.heightMm
                            : 2.0 * halfHeight(camera) * glm::length(camera.target - camera.position);
  const glm::dvec3 shift = (basis.right * x + basis.up * y) * height;
  Camera moved = camera;
  moved.position -= shift;
  moved.target -= shift;
  return moved;
}

Camera zoomed(const Camera& camera, double factor) {
  assert(factor > 0.0);
  Camera moved = camera;
  if (camera.projection == Camera::Projection::orthographic)
    moved.heightMm /= factor;
  else
    moved.position = camera.target + (camera.position - camera.target) / factor;
  return moved;
}

} // namespace limn
