// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/CropBoxOverlay.h"

#include "widgets/ValueText.h"
#include "widgets/properties/CropFaces.h"

#include <QObject>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

// A place of a face, 0 to 1 along its two axes.
glm::dvec3 onFace(const CropBox& crop, const Grid& grid, CropFace face, const glm::dvec2& at) {
  glm::dvec3 fraction;
  fraction[face.axis] = placeOf(crop, face);
  for (int i = 0; i < 2; ++i) {
    const int axis = (face.axis + 1 + i) % 3;
    fraction[axis] = glm::mix(crop.lower[axis], crop.upper[axis], at[i]);
  }
  return worldAt(grid, fraction);
}

// What of a picture the pointer can take all of a handle in.
QRectF reachOf(const ViewProjection& projection) {
  return projection.picture.adjusted(cropHandleHitRadius, cropHandleHitRadius, -cropHandleHitRadius,
                                     -cropHandleHitRadius);
}

// Where the handle stands of a place of a face: there or, beyond the picture, at its edge.
QPointF standsAt(const ViewProjection& projection, const QPointF& pixel) {
  const QRectF reach = reachOf(projection);
  return {std::max(reach.left(), std::min(pixel.x(), reach.right())),
          std::max(reach.top(), std::min(pixel.y(), reach.bottom()))};
}

// Where a face is held: in its middle or, where that lies beyond the picture, at the place nearest to it, as
// seen, of what the picture shows of the face; in its middle if it shows none.
glm::dvec3 heldAt(const CropBox& crop, const Grid& grid, CropFace face, const ViewProjection& projection) {
  constexpr int steps = 16;
  const glm::dvec3 middle = faceCentre(crop, grid, face);
  const std::optional<QPointF> wanted = pixelOf(projection, middle);
  const QRectF reach = reachOf(projection);
  if (!wanted || reach.contains(*wanted))
    return middle;
  std::optional<glm::dvec2> best;
  double nearest = std::numeric_limits<double>::max();
  glm::dvec2 around(0.5);
  double span = 1.0; // of what is searched, an eighth each time: to less than a pixel
  for (int round = 0; round < 4; ++round, span /= 8.0) {
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const glm::dvec2 at = glm::clamp(around + span * (glm::dvec2(i, j) / double(steps) - 0.5), 0.0, 1.0);
        const std::optional<QPointF> pixel = pixelOf(projection, onFace(crop, grid, face, at));
        if (!pixel || !reach.contains(*pixel))
          continue;
        if (const double away = QLineF(*pixel, *wanted).length(); away < nearest) {
          nearest = away;
          best = at;
        }
      }
    if (!best)
      return middle;
    around = *best;
  }
  return onFace(crop, grid, face, *best);
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
  const std::optional<QPointF> middle = pixelOf(projection, heldAt(crop, grid, face, projection));
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
  return CropHandle{face, standsAt(projection, *middle + shareInside(room, *middle, *best) * way),
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

// What the face of a handle is called and cuts off, beside the handle and within its picture.
Note cropNote(const OverlaySource& source, const QRectF& picture, const CropHandle& handle) {
  const Volume& volume = source.volume();
  const CropFace face = handle.face;
  const TurnedBox box = boxOver(source.comparison);
  const double cut = cutBy(box, face);
  const bool isTurned = source.comparison.turnedBox.has_value();
  QString text = isTurned ? QObject::tr("Turned box, %1").arg(turnedFaceName(box, volume, face))
                          : cropFaceName(volume, face);
  if (cut > 0.0 && isTurned) { // a share of what is around it would say nothing
    const double shown = placeOf(box.fit, {face.axis, true}) - placeOf(box.fit, {face.axis, false});
    text = QObject::tr("%1: %2 % cut").arg(text, plainNumber(100.0 * cut / shown, 1));
  } else if (cut > 0.0)
    text = QObject::tr("%1: %2 % cut").arg(text, plainNumber(100.0 * cut, 1));
  if (cut > 0.0 && volume.info().spacingKnown)
    text += QObject::tr(" · %1 mm").arg(plainNumber(cut * boxSizeMm(box.grid)[face.axis], 1));
  Note note = noteAt(source.font, text, {0.0, 0.0}, Qt::AlignLeft, source.geometry.size.width());
  note.plate.moveCenter(handle.centre + QPointF(0.0, -28.0));
  const QRectF room = picture.adjusted(4.0, 4.0, -4.0, -4.0);
  note.plate.moveLeft(std::max(room.left(), std::min(note.plate.left(), room.right() - note.plate.width())));
  note.plate.moveTop(std::max(room.top(), note.plate.top()));
  return note;
}

// Opaque inks: Qt blends a translucent line over the whole rectangle around it, which costs a software driver
// as much as a coarse picture. Everything light has something dark around it, so that it stands out from
// bright bone and from black alike.
const QColor lightColor(255, 255, 255);
const QColor darkColor(12, 14, 18);
const QColor hiddenColor(122, 128, 138); // of handles behind the box
const QColor accentColor(77, 163, 255);

// Dashes of 4 pixels, whatever their width: Qt counts in widths.
QPen linePen(const QColor& color, double width, bool isDashed) {
  QPen pen(color, width, Qt::SolidLine, Qt::FlatCap);
  if (isDashed)
    pen.setDashPattern({4.0 / width, 4.0 / width});
  return pen;
}

void paintEdges(QPainter& painter, const CropBoxShape& shape, bool hidden) {
  for (const auto& [color, width] : {std::pair(darkColor, 3.5), std::pair(lightColor, 1.5)}) {
    painter.setPen(linePen(color, width, hidden));
    for (const CropEdge& edge : shape.edges)
      if (edge.isHidden == hidden)
        painter.drawLine(edge.line);
  }
}

// A dark ring, a light one in it, and what tells its state in the middle.
void paintHandle(QPainter& painter, const CropHandle& handle, bool lively) {
  const double radius = lively ? cropHandleRadius + 1.5 : cropHandleRadius;
  painter.setPen(Qt::NoPen);
  const QColor middle = lively ? accentColor : handle.isHidden ? hiddenColor : lightColor;
  for (const auto& [color, inset] :
       {std::pair(darkColor, 0.0), std::pair(lightColor, 1.5), std::pair(middle, 3.0)}) {
    painter.setBrush(color);
    painter.drawEllipse(handle.centre, radius + 1.5 - inset, radius + 1.5 - inset);
  }
}

void paintHandles(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively,
                  bool hidden) {
  for (const CropHandle& handle : shape.handles)
    if (handle.isHidden == hidden)
      paintHandle(painter, handle, lively == handle.face);
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
    const glm::dvec3 centre = heldAt(crop, grid, face, projection);
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
    shape.handles.push_back({face, standsAt(projection, *pixel), length > 0.0 ? way / length : QPointF(),
                             facesAway(crop, grid, face, projection)});
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
  const glm::dvec3 start = heldAt(crop, grid, face, projection);
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
  const double along = QPointF::dotProduct(pixel - standsAt(projection, *startPixel), way);
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

std::vector<CropBoxOverlay> cropBoxesOf(const OverlaySource& source) {
  std::vector<CropBoxOverlay> boxes;
  if (!source.hasCropBox)
    return boxes;
  for (int position = 0; position < standingCount(source.geometry); ++position) {
    CropBoxOverlay box{pictureRect(source.geometry, position),
                       cropShapeAt(source.comparison, source.geometry, position),
                       source.heldFace ? source.heldFace : source.hovered.face,
                       {}};
    for (const CropHandle& handle : box.shape.handles)
      if (box.lively == handle.face)
        box.note = cropNote(source, box.picture, handle);
    boxes.push_back(box);
  }
  return boxes;
}

TurnedBox boxOver(const Comparison& comparison) {
  return comparison.turnedBox.value_or(TurnedBox{comparison.scene.volume->grid(), comparison.scene.crop});
}

CropBoxShape cropShapeAt(const Comparison& comparison, const ViewGeometry& geometry, int position) {
  const TurnedBox box = boxOver(comparison);
  return cropBoxShape(box.crop, box.grid,
                      viewProjection(comparison.scene.camera, pictureRect(geometry, position)));
}

std::optional<CropHandle> cropHandleAt(const OverlaySource& source, const QPointF& point) {
  if (!source.hasCropBox)
    return std::nullopt;
  const int position = standingAt(source.geometry, point);
  return handleAt(cropShapeAt(source.comparison, source.geometry, position), point);
}

void paintCropBox(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const bool hidden : {true, false}) {
    paintEdges(painter, shape, hidden);
    paintHandles(painter, shape, lively, hidden);
  }
  painter.restore();
}

Qt::CursorShape cursorFor(const CropHandle& handle) {
  // The angle of the way, y up, folded to a half turn and counted in eighths of a turn.
  const double angle = std::atan2(-handle.outward.y(), handle.outward.x()) / std::numbers::pi * 4.0;
  const Qt::CursorShape cursors[] = {Qt::SizeHorCursor, Qt::SizeBDiagCursor, Qt::SizeVerCursor,
                                     Qt::SizeFDiagCursor};
  return cursors[(std::lround(angle) + 8) % 4];
}

} // namespace limn
