// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/ViewGeometry.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double pictureGap = 2.0; // between pictures side by side, logical pixels
constexpr double wipeGrip = 12.0;  // to each side of the border

bool isPerspective(const ViewProjection& projection) {
  return projection.camera.projection == Camera::Projection::perspective;
}

// Pixels per unit of the picture plane: of slope for a perspective camera, of mm for an orthographic one.
double pixelsPerUnit(const ViewProjection& projection) {
  return projection.picture.height() / (2.0 * halfHeight(projection.camera));
}

} // namespace

glm::ivec2 deviceSize(const ViewGeometry& geometry) {
  return {static_cast<int>(std::lround(geometry.size.width() * geometry.pixelRatio)),
          static_cast<int>(std::lround(geometry.size.height() * geometry.pixelRatio))};
}

std::vector<PixelRect> pictureRects(const ViewGeometry& geometry) {
  const glm::ivec2 size = deviceSize(geometry);
  if (size.y < 1)
    return {};
  if (geometry.layout == CompareLayout::sideBySide) {
    const double gap = geometry.hasGap ? pictureGap * geometry.pixelRatio : 0.0;
    const int width = (size.x - static_cast<int>(std::lround(gap))) / 2;
    if (width < 1)
      return {};
    return {{{0, 0}, {width, size.y}}, {{size.x - width, 0}, {width, size.y}}};
  }
  if (size.x < 1)
    return {};
  return std::vector<PixelRect>(pictureCount(geometry.layout), PixelRect{{0, 0}, size});
}

QRectF pictureRect(const ViewGeometry& geometry, int position) {
  const std::vector<PixelRect> places = pictureRects(geometry);
  if (position >= static_cast<int>(places.size()))
    return QRectF({0.0, 0.0}, QSizeF(geometry.size));
  const double ratio = geometry.pixelRatio;
  const PixelRect& place = places[static_cast<std::size_t>(position)];
  return {place.topLeft.x / ratio, place.topLeft.y / ratio, place.size.x / ratio, place.size.y / ratio};
}

double pictureAspect(const ViewGeometry& geometry) {
  const std::vector<PixelRect> places = pictureRects(geometry);
  return places.empty() ? 1.0 : static_cast<double>(places[0].size.x) / places[0].size.y;
}

int standingCount(const ViewGeometry& geometry) {
  return geometry.layout == CompareLayout::sideBySide ? 2 : 1;
}

int wipeColumn(const ViewGeometry& geometry) {
  return static_cast<int>(std::lround(std::clamp(geometry.wipe, 0.0, 1.0) * deviceSize(geometry).x));
}

double wipeX(const ViewGeometry& geometry) {
  return geometry.wipe * geometry.size.width();
}

bool isOnWipeBorder(const ViewGeometry& geometry, const QPointF& point) {
  return geometry.layout == CompareLayout::wipe && std::abs(point.x() - wipeX(geometry)) <= wipeGrip;
}

int positionAt(const ViewGeometry& geometry, const QPointF& point) {
  const double x = point.x() * geometry.pixelRatio;
  switch (geometry.layout) {
  case CompareLayout::sideBySide:
    return x < 0.5 * deviceSize(geometry).x ? 0 : 1;
  case CompareLayout::wipe:
    return x < wipeColumn(geometry) ? 0 : 1;
  case CompareLayout::single:
  case CompareLayout::difference:
    break;
  }
  return 0;
}

int standingAt(const ViewGeometry& geometry, const QPointF& point) {
  return geometry.layout == CompareLayout::sideBySide ? positionAt(geometry, point) : 0;
}

ViewProjection viewProjection(const Camera& camera, const QRectF& picture) {
  return {camera, basisOf(camera), picture};
}

double depthMm(const ViewProjection& projection, const glm::dvec3& world) {
  return glm::dot(world - projection.camera.position, projection.basis.forward);
}

std::optional<QPointF> pixelOf(const ViewProjection& projection, const glm::dvec3& world) {
  const glm::dvec3 offset = world - projection.camera.position;
  double scale = pixelsPerUnit(projection);
  if (isPerspective(projection)) {
    const double depth = glm::dot(offset, projection.basis.forward);
    if (!(depth > 0.0))
      return std::nullopt;
    scale /= depth;
  }
  return projection.picture.center() + QPointF(scale * glm::dot(offset, projection.basis.right),
                                               -scale * glm::dot(offset, projection.basis.up));
}

QPointF pixelsPerMm(const ViewProjection& projection, const glm::dvec3& world, const glm::dvec3& along) {
  const CameraBasis& basis = projection.basis;
  double scale = pixelsPerUnit(projection);
  glm::dvec2 way(glm::dot(along, basis.right), glm::dot(along, basis.up));
  if (isPerspective(projection)) {
    // The derivative of (x/z, y/z).
    const glm::dvec3 offset = world - projection.camera.position;
    const double depth = glm::dot(offset, basis.forward);
    const glm::dvec2 place(glm::dot(offset, basis.right), glm::dot(offset, basis.up));
    way -= place / depth * glm::dot(along, basis.forward);
    scale /= depth;
  }
  return {scale * way.x, -scale * way.y};
}

Ray rayThrough(const ViewProjection& projection, const QPointF& pixel) {
  const CameraBasis& basis = projection.basis;
  const QPointF plane = (pixel - projection.picture.center()) / pixelsPerUnit(projection);
  const glm::dvec3 offset = basis.right * plane.x() - basis.up * plane.y();
  if (isPerspective(projection))
    return {projection.camera.position, glm::normalize(basis.forward + offset)};
  return {projection.camera.position + offset, basis.forward};
}

} // namespace limn
