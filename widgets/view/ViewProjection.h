// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

#include <QPointF>
#include <QRectF>

#include <optional>

namespace limn {

/// How a camera maps world millimetres to the logical pixels of a picture, y down: the inverse of
/// rayThroughPixel, for what is drawn over the picture.
struct ViewProjection {
  Camera camera;
  CameraBasis basis;
  QRectF picture;
};

/// `picture` in logical pixels, not empty.
ViewProjection viewProjection(const Camera& camera, const QRectF& picture);

/// The distance of a place from the camera along the direction of view, mm; negative behind it.
double depthMm(const ViewProjection& projection, const glm::dvec3& world);

/// Where a place is seen; nothing where it is not before the eye of a perspective camera.
std::optional<QPointF> pixelOf(const ViewProjection& projection, const glm::dvec3& world);

/// The way a place before the eye moves in the picture, pixels per mm, as it sets out along a world vector.
QPointF pixelsPerMm(const ViewProjection& projection, const glm::dvec3& world, const glm::dvec3& along);

/// The ray through a pixel position, which need not lie inside the picture.
Ray rayThrough(const ViewProjection& projection, const QPointF& pixel);

} // namespace limn
