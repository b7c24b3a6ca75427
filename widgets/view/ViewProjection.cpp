// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/ViewProjection.h"

namespace limn {
namespace {

bool isPerspective(const ViewProjection& projection) {
  return projection.camera.projection == Camera::Projection::perspective;
}

// Pixels per unit of the picture plane: of slope for a perspective camera, of mm for an orthographic one.
double pixelsPerUnit(const ViewProjection& projection) {
  return projection.picture.height() / (2.0 * halfHeight(projection.camera));
}

} // namespace

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
