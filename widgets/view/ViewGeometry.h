// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/PixelRect.h"
#include "scene/view/CompareLayout.h"

#include <QPointF>
#include <QRectF>
#include <QSize>

#include <vector>

namespace limn {

/// What decides where the pictures lie in a view.
struct ViewGeometry {
  CompareLayout layout = CompareLayout::single;
  double wipe = 0.5;       ///< where the border of the wipe lies, as a fraction of the width
  QSize size;              ///< of the view, logical pixels
  double pixelRatio = 1.0; ///< device pixels per logical one, each way
};

/// The size of the view in device pixels.
glm::ivec2 deviceSize(const ViewGeometry& geometry);

/// Where the pictures lie, device pixels, y down; in `wipe` and `difference` both fill the view. Side by side
/// they are equal in size, with two logical pixels between them (one device pixel more where the width is
/// odd). Empty where the view is too small to show them.
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

} // namespace limn
