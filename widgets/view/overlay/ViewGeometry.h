// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PixelRect.h"
#include "scene/view/Camera.h"
#include "scene/view/CompareLayout.h"

#include <QPointF>
#include <QRectF>
#include <QSize>

#include <optional>
#include <vector>

namespace limn {

/// What decides where the pictures lie in a view.
struct ViewGeometry {
  CompareLayout layout = CompareLayout::single;
  double wipe = 0.5;       ///< where the border of the wipe lies, as a fraction of the width
  QSize size;              ///< of the view, logical pixels
  double pixelRatio = 1.0; ///< device pixels per logical one, each way
  bool hasGap = true;      ///< between pictures side by side; in a file they touch
  bool operator==(const ViewGeometry&) const = default;
};

/// The size of the view in device pixels.
glm::ivec2 deviceSize(const ViewGeometry& geometry);

/// Where the pictures lie, device pixels, y down; in `wipe` and `difference` both fill the view. Side by side
/// they are equal in size, with a gap of two logical pixels between them (one device pixel more where the
/// width is odd). Empty where the view is too small to show them.
std::vector<PixelRect> pictureRects(const ViewGeometry& geometry);

/// Where the picture at `position` (0 left, 1 right) lies, logical pixels; the view where it is too small.
QRectF pictureRect(const ViewGeometry& geometry, int position);

/// Width over height of one picture; 1 where there is no room for it.
double pictureAspect(const ViewGeometry& geometry);

/// How many pictures lie beside each other, each with what stands above it: 1 or 2.
int standingCount(const ViewGeometry& geometry);

/// The border of the wipe: a device column, and logical pixels.
int wipeColumn(const ViewGeometry& geometry);
double wipeX(const ViewGeometry& geometry);

/// Whether the pointer can take hold of the border of the wipe.
bool isOnWipeBorder(const ViewGeometry& geometry, const QPointF& point);

/// The position of the picture seen under a point, logical pixels: 0 or 1.
int positionAt(const ViewGeometry& geometry, const QPointF& point);

/// The same where what lies over each other counts as one.
int standingAt(const ViewGeometry& geometry, const QPointF& point);

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
