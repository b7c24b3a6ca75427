// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/PlaneGrid.h"

#include <QPointF>
#include <QSizeF>

#include <optional>

namespace limn {

/// A part of a plane that somebody chose to see; without it all of the grid is seen.
struct PlaneZoom {
  glm::dvec3 centreMm{0.0}; ///< world, in the middle of the view
  double mmPerPixel = 1.0;  ///< logical pixels, > 0
  bool operator==(const PlaneZoom&) const = default;
};

/// A plane as it lies in a view: a pixel of its grid is a device pixel, and the grid fills the view.
struct PlaneFrame {
  PlaneGrid grid;
  double pixelRatio = 1.0; ///< device pixels per logical one, each way
};

/// The frame of a view of this size (logical pixels, at least 1 each way) through a place in the world, which
/// shows all of a grid, or what was chosen.
PlaneFrame planeFrame(const Grid& seen, PatientPlane plane, const glm::dvec3& throughMm, const QSizeF& size,
                      double pixelRatio, const std::optional<PlaneZoom>& zoom);

/// Between the world and points of the view, logical pixels. What is seen at a point lies in the plane.
QPointF pointOf(const PlaneFrame& frame, const glm::dvec3& worldMm);
glm::dvec3 worldAt(const PlaneFrame& frame, const QPointF& point);

/// The same along both axes of the view.
double mmPerLogicalPixel(const PlaneFrame& frame);

/// What is seen after zooming by `factor` > 1 (nearer) or < 1 about a point of the view, or after dragging it
/// by logical pixels. From a hundredth of a millimetre to a metre per pixel.
PlaneZoom zoomedAbout(const PlaneFrame& frame, const QPointF& point, double factor);
PlaneZoom pannedBy(const PlaneFrame& frame, const QPointF& moved);

} // namespace limn
