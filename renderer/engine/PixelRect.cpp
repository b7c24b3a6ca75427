// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/PixelRect.h"

#include <optional>

namespace limn {
namespace {

// Pixels by which a corner may be misplaced, in float as in double.
constexpr double margin = 1.0;

// Beyond so many pixels differences of positions are rounded by a part of one.
constexpr double mostPixels = 0x1p47;

// Where a point is seen, pixels from the picture's centre, y up; nothing where it is not before the eye, or
// the eye so far that rounding decides.
std::optional<glm::dvec2> seenAt(const Camera& camera, const CameraBasis& basis, const glm::dvec3& world,
                                 double height) {
  const glm::dvec3 fromEye = world - camera.position;
  const double depth = glm::dot(fromEye, basis.forward);
  const bool isPerspective = camera.projection == Camera::Projection::perspective;
  if (isPerspective && !(depth > 1e-6 * glm::length(fromEye)))
    return std::nullopt;
  const double pixelsPerMm = height / (2.0 * halfHeight(camera) * (isPerspective ? depth : 1.0));
  if (!(pixelsPerMm * glm::length(fromEye) < mostPixels))
    return std::nullopt;
  return pixelsPerMm * glm::dvec2(glm::dot(fromEye, basis.right), glm::dot(fromEye, basis.up));
}

} // namespace

PixelRect coveredPixels(const Camera& camera, const Grid& grid, const IndexBox& box, const glm::ivec2& size) {
  if (glm::any(glm::lessThanEqual(box.upper, box.lower)))
    return {};
  const CameraBasis basis = basisOf(camera);
  const glm::dvec2 picture(size);
  glm::dvec2 lower = picture;
  glm::dvec2 upper(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::bvec3 isUpper(corner & 1, corner & 2, corner & 4);
    const glm::dvec3 index = glm::mix(box.lower, box.upper, isUpper) + centreIndex(grid);
    const auto seen = seenAt(camera, basis, indexToWorld(grid, index), picture.y);
    if (!seen)
      return {{0, 0}, size};
    const glm::dvec2 pixel = picture / 2.0 + glm::dvec2(seen->x, -seen->y);
    lower = glm::min(lower, pixel - margin);
    upper = glm::max(upper, pixel + margin);
  }
  const glm::ivec2 first(glm::floor(glm::clamp(lower, glm::dvec2(0.0), picture)));
  const glm::ivec2 end(glm::ceil(glm::clamp(upper, glm::dvec2(0.0), picture)));
  return {first, glm::max(end - first, 0)};
}

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  const glm::ivec2 first = glm::max(a.topLeft, b.topLeft);
  const glm::ivec2 end = glm::min(a.topLeft + a.size, b.topLeft + b.size);
  return {first, glm::max(end - first, 0)};
}

} // namespace limn
