// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CropBoxGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

// Below this sine of the angle between a face's axis and the line of sight (11.5°) a pixel of the pointer
// would move the face by many, and the handles of front and back would lie over each other.
constexpr double leastSine = 0.2;

// How far from the edges of a picture a handle stays that stands for a face, pixels: clear of the titles
// above and of scale and notes below, which would hide it and take its presses. Of a low picture a quarter.
constexpr double fromSides = 20.0;
constexpr double fromTexts = 60.0;

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

bool liesAcross(const CropBox& crop, const Grid& grid, CropFace face, const ViewProjection& projection) {
  const glm::dvec3 sight = lineOfSight(projection, faceCentre(crop, grid, face));
  return glm::length(glm::cross(outwardNormal(grid, face), sight)) < leastSine;
}

// The share of the way from `from` to `to` that stays inside a rectangle; 0 where it begins outside.
double shareInside(const QRectF& room, const QPointF& from, const QPointF& to) {
  const auto along = [](double start, double end, double low, double high) {
    return end > high ? (high - start) / (end - start) : end < low ? (low - start) / (end - start) : 1.0;
  };
  return std::clamp(std::min(along(from.x(), to.x(), room.left(), room.right()),
                             along(from.y(), to.y(), room.top(), room.bottom())),
                    0.0, 1.0);
}

// The handle of a face across the line of sight; nothing where a corner of it lies behind the eye.
std::optional<CropHandle> handleAcross(const CropBox& crop, const Grid& grid, CropFace face,
                                       const ViewProjection& projection) {
  const bool isBehind = facesAway(crop, grid, face, projection);
  const QPointF wanted = isBehind ? QPointF(-1.0, 1.0) : QPointF(1.0, -1.0);
  const std::optional<QPointF> middle = pixelOf(projection, faceCentre(crop, grid, face));
  std::optional<QPointF> best;
  for (int corner = 0; corner < 4; ++corner) {
    glm::dvec3 fraction = crop.lower;
    fraction[face.axis] = placeOf(crop, face);
    for (const int other : {1, 2})
      if (const int axis = (face.axis + other) % 3; (corner & other) != 0)
        fraction[axis] = crop.upper[axis];
    const std::optional<QPointF> pixel = pixelOf(projection, worldAt(grid, fraction));
    if (!pixel)
      return std::nullopt;
    if (!best || QPointF::dotProduct(*pixel - *best, wanted) > 0.0)
      best = pixel;
  }
  if (!middle || !best || *best == *middle)
    return std::nullopt;
  const QPointF way = *best - *middle;
  const double fromRows = std::min(fromTexts, projection.picture.height() / 4.0);
  const QRectF room = projection.picture.adjusted(fromSides, fromRows, -fromSides, -fromRows);
  return CropHandle{face, *middle + shareInside(room, *middle, *best) * way,
                    way / std::hypot(way.x(), way.y()), isBehind, true};
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
    if (liesAcross(crop, grid, face, projection)) {
      if (const std::optional<CropHandle> handle = handleAcross(crop, grid, face, projection))
        shape.handles.push_back(*handle);
      continue;
    }
    const glm::dvec3 outward = outwardNormal(grid, face);
    const QPointF way = pixelsPerMm(projection, centre, outward);
    const double length = std::hypot(way.x(), way.y());
    shape.handles.push_back(
        {face, *pixel, length > 0.0 ? way / length : QPointF(), facesAway(crop, grid, face, projection)});
  }
  return shape;
}

std::optional<CropHandle> handleAt(const CropBoxShape& shape, const QPointF& pixel) {
  std::optional<CropHandle> nearest;
  double best = 0.0;
  for (const CropHandle& handle : shape.handles) {
    const double distance = QLineF(handle.centre, pixel).length();
    if (distance > cropHandleHitRadius)
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
  if (liesAcross(crop, grid, face, projection)) {
    const std::optional<CropHandle> handle = handleAcross(crop, grid, face, projection);
    if (!handle)
      return before;
    const QPointF perMm = pixelsPerMm(projection, start, projection.basis.right);
    const double outMm =
        QPointF::dotProduct(pixel - handle->centre, handle->outward) / std::hypot(perMm.x(), perMm.y());
    return before + (face.isUpper ? outMm : -outMm) / boxSizeMm(grid)[face.axis];
  }
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
