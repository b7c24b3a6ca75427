// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CropBoxGeometry.h"

#include <cmath>
#include <limits>

namespace limn {
namespace {

// Below this sine of the angle between a face's axis and the line of sight (9°) a pixel of the pointer would
// move the face by many.
constexpr double leastSine = 0.15;

glm::dvec3 worldAt(const Grid& grid, const glm::dvec3& fraction) {
  return indexToWorld(grid, fraction * glm::dvec3(grid.dims) - 0.5);
}

glm::dvec3 outwardNormal(const Grid& grid, CropFace face) {
  return face.isUpper ? grid.direction[face.axis] : -grid.direction[face.axis];
}

glm::dvec3 lineOfSight(const ViewProjection& projection, const glm::dvec3& place) {
  if (projection.camera.projection == Camera::Projection::orthographic)
    return projection.basis.forward;
  const glm::dvec3 way = place - projection.camera.position;
  const double length = glm::length(way);
  return length > 0.0 ? way / length : projection.basis.forward;
}

bool facesAway(const CropBox& crop, const Grid& grid, CropFace face, const ViewProjection& projection) {
  return glm::dot(outwardNormal(grid, face), lineOfSight(projection, faceCentre(crop, grid, face))) >= 0.0;
}

// The part of a line before the eye of a perspective camera.
std::optional<QLineF> seenLine(const ViewProjection& projection, glm::dvec3 from, glm::dvec3 to,
                               double nearestMm) {
  if (projection.camera.projection == Camera::Projection::perspective) {
    double a = depthMm(projection, from);
    double b = depthMm(projection, to);
    if (a < nearestMm && b < nearestMm)
      return std::nullopt;
    if (a < nearestMm)
      from = glm::mix(from, to, (nearestMm - a) / (b - a));
    else if (b < nearestMm)
      to = glm::mix(to, from, (nearestMm - b) / (a - b));
  }
  return QLineF(*pixelOf(projection, from), *pixelOf(projection, to));
}

void addEdges(CropBoxShape& shape, const CropBox& crop, const Grid& grid, const ViewProjection& projection) {
  const double nearestMm = 1e-3 * boxDiagonalMm(grid);
  for (int along = 0; along < 3; ++along) {
    const int second = (along + 1) % 3;
    const int third = (along + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      const CropFace one{second, (corner & 1) != 0};
      const CropFace other{third, (corner & 2) != 0};
      glm::dvec3 from = crop.lower;
      from[second] = placeOf(crop, one);
      from[third] = placeOf(crop, other);
      glm::dvec3 to = from;
      to[along] = crop.upper[along];
      const bool hidden = facesAway(crop, grid, one, projection) && facesAway(crop, grid, other, projection);
      if (const auto line = seenLine(projection, worldAt(grid, from), worldAt(grid, to), nearestMm))
        shape.edges.push_back({*line, hidden});
    }
  }
}

} // namespace

glm::dvec3 faceCentre(const CropBox& crop, const Grid& grid, CropFace face) {
  glm::dvec3 fraction = 0.5 * (crop.lower + crop.upper);
  fraction[face.axis] = placeOf(crop, face);
  return worldAt(grid, fraction);
}

CropBoxShape cropBoxShape(const CropBox& crop, const Grid& grid, const ViewProjection& projection) {
  CropBoxShape shape;
  addEdges(shape, crop, grid, projection);
  for (const CropFace face : cropFaces) {
    const glm::dvec3 centre = faceCentre(crop, grid, face);
    const std::optional<QPointF> pixel = pixelOf(projection, centre);
    if (!pixel)
      continue;
    const glm::dvec3 outward = outwardNormal(grid, face);
    const QPointF way = pixelsPerMm(projection, centre, outward);
    const double length = std::hypot(way.x(), way.y());
    const double sine = glm::length(glm::cross(outward, lineOfSight(projection, centre)));
    shape.handles.push_back({face, *pixel, length > 0.0 ? way / length : QPointF(),
                             facesAway(crop, grid, face, projection), sine >= leastSine});
  }
  return shape;
}

std::optional<CropHandle> handleAt(const CropBoxShape& shape, const QPointF& pixel) {
  std::optional<CropHandle> nearest;
  double best = 0.0;
  for (const CropHandle& handle : shape.handles) {
    const double distance = QLineF(handle.centre, pixel).length();
    if (!handle.canMove || distance > cropHandleHitRadius)
      continue;
    const bool better = !nearest || (nearest->isHidden && !handle.isHidden) ||
                        (nearest->isHidden == handle.isHidden && distance < best);
    if (!better)
      continue;
    nearest = handle;
    best = distance;
  }
  return nearest;
}

double placeUnder(const CropBox& crop, const Grid& grid, CropFace face, const ViewProjection& projection,
                  const QPointF& pixel) {
  const double before = placeOf(crop, face);
  const glm::dvec3 start = faceCentre(crop, grid, face);
  const glm::dvec3 axis = grid.direction[face.axis];
  const std::optional<QPointF> startPixel = pixelOf(projection, start);
  const QPointF way = startPixel ? pixelsPerMm(projection, start, axis) : QPointF();
  const double squared = QPointF::dotProduct(way, way);
  if (!(squared > 0.0))
    return before;

  // Lead the pointer to the axis as it lies in the picture, then meet it in the volume.
  const double along = QPointF::dotProduct(pixel - *startPixel, way);
  const Ray ray = rayThrough(projection, *startPixel + along / squared * way);
  const glm::dvec3 w = start - ray.origin;
  const double cosine = glm::dot(axis, ray.direction);
  const double sineSquared = 1.0 - cosine * cosine;
  const double onRay = glm::dot(ray.direction, w) - cosine * glm::dot(axis, w);
  const bool beyondVanishing =
      sineSquared < 1e-12 ||
      (projection.camera.projection == Camera::Projection::perspective && onRay <= 0.0);
  if (beyondVanishing)
    return std::copysign(std::numeric_limits<double>::infinity(), along);
  const double movedMm = (cosine * glm::dot(ray.direction, w) - glm::dot(axis, w)) / sineSquared;
  return before + movedMm / boxSizeMm(grid)[face.axis];
}

} // namespace limn
