// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/RayFrame.h"

#include "scene/basics/StableMath.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Directions that leave an axis by less than a billionth of a voxel over the whole box run along the others:
// what is left of a rotation's rounding must not decide on which side of a face a ray lies.
glm::dvec3 withoutRounding(glm::dvec3 direction, double lengthMm) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(direction[axis]) * lengthMm < 1e-9)
      direction[axis] = 0.0;
  return direction;
}

// How far from the eye rays are anchored. Perspective eyes close to the box anchor them themselves: rays at
// the edge of a wide picture meet the plane through the centre so far away that a float's digits would be
// lost.
double anchorDistance(const Camera& camera, const CameraBasis& basis, const glm::dvec3& eye,
                      double diagonalMm) {
  const bool isClose = glm::length(eye) <= 0.6 * diagonalMm; // beyond the corners, by more than rounding
  if (isClose && camera.projection == Camera::Projection::perspective)
    return 0.0;
  return std::max(0.0, -glm::dot(eye, basis.forward));
}

} // namespace

glm::dvec3 centreIndex(const Grid& grid) {
  return (glm::dvec3(grid.dims) - 1.0) / 2.0;
}

RayFrame rayFrame(const Camera& camera, const Grid& grid, const glm::ivec2& size) {
  const CameraBasis basis = basisOf(camera);
  const glm::dvec3 eye = camera.position - boxCentreMm(grid);
  const double pixel = 2.0 * halfHeight(camera) / size.y;
  const auto toIndex = [&grid](const glm::dvec3& v) { return worldVectorToIndex(grid, v); };

  RayFrame frame;
  frame.anchorDistanceMm = anchorDistance(camera, basis, eye, boxDiagonalMm(grid));
  frame.anchor = toIndex(eye + frame.anchorDistanceMm * basis.forward);
  frame.direction = withoutRounding(toIndex(basis.forward), boxDiagonalMm(grid));
  if (camera.projection == Camera::Projection::orthographic) {
    frame.anchorX = toIndex(basis.right) * pixel;
    frame.anchorY = toIndex(basis.up) * pixel;
  } else {
    frame.tangentPerPixel = pixel;
    frame.directionX = toIndex(basis.right) * pixel;
    frame.directionY = toIndex(basis.up) * pixel;
    frame.anchorX = frame.directionX * frame.anchorDistanceMm;
    frame.anchorY = frame.directionY * frame.anchorDistanceMm;
  }
  return frame;
}

FramedRay framedRay(const RayFrame& frame, int x, int y, const glm::ivec2& size) {
  const double cx = x + 0.5 - size.x / 2.0;
  const double cy = size.y / 2.0 - (y + 0.5);
  const double length = std::sqrt(1.0 + (cx * cx + cy * cy) * frame.tangentPerPixel * frame.tangentPerPixel);
  FramedRay ray;
  ray.anchor = frame.anchor + cx * frame.anchorX + cy * frame.anchorY;
  ray.direction = (frame.direction + cx * frame.directionX + cy * frame.directionY) / length;
  ray.eye = -frame.anchorDistanceMm * length;
  return ray;
}

IndexBox croppedBox(const Grid& grid, const CropBox& crop) {
  const glm::dvec3 dims(grid.dims);
  return {dims * (crop.lower - 0.5), dims * (crop.upper - 0.5)};
}

CutPlanes cutPlanes(const Grid& grid, const CropBox& crop) {
  const IndexBox box = croppedBox(grid, crop);
  CutPlanes planes{glm::dvec3(-1e9), glm::dvec3(1e9)};
  for (int axis = 0; axis < 3; ++axis) {
    if (crop.lower[axis] > 0.0)
      planes.lower[axis] = box.lower[axis];
    if (crop.upper[axis] < 1.0)
      planes.upper[axis] = box.upper[axis];
  }
  return planes;
}

glm::dvec3 towardsLightAlongAxes(const glm::dvec3& directionWorld, const Grid& grid) {
  return glm::transpose(grid.direction) * -glm::dvec3(safeNormal(directionWorld));
}

std::optional<glm::dvec3> towardsLight(const LightingTerms& terms, const Camera& camera, const Grid& grid) {
  const std::optional<glm::dvec3> travels = lightTravels(terms, camera);
  return travels ? std::optional(towardsLightAlongAxes(*travels, grid)) : std::nullopt;
}

RaySpan spanInBox(const FramedRay& ray, const IndexBox& box) {
  RaySpan span{ray.eye, 1e300};
  for (int axis = 0; axis < 3; ++axis) {
    const double p = ray.anchor[axis];
    const double d = ray.direction[axis];
    if (std::abs(d) < 1e-20) {
      if (!(p >= box.lower[axis] && p < box.upper[axis]))
        return {};
      continue;
    }
    const double a = (box.lower[axis] - p) / d;
    const double b = (box.upper[axis] - p) / d;
    span.begin = std::max(span.begin, std::min(a, b));
    span.end = std::min(span.end, std::max(a, b));
  }
  return span;
}

int sampleCount(double lengthMm, double step, int most) {
  const double wanted = std::ceil(lengthMm / step * (1.0 - stepCountGuard));
  return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(most)));
}

double jitteredOffset(int x, int yDown, int height) {
  const int px = x & 7;
  const int py = (height - 1 - yDown) & 7;
  const int q = px ^ py;
  // Interleave the bits of q and py, the lowest first: neighbours differ as much as possible.
  const int rank = (q & 1) << 5 | (py & 1) << 4 | (q & 2) << 2 | (py & 2) << 1 | (q & 4) >> 1 | (py & 4) >> 2;
  return (rank + 0.5) / 64.0;
}

double stepMm(const Scene& scene) {
  return scene.quality.stepVoxels * smallestSpacingMm(scene.volume->grid());
}

double longestRaySamples(const Scene& scene) {
  return boxDiagonalMm(scene.volume->grid()) / stepMm(scene);
}

} // namespace limn
