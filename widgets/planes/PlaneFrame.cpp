// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneFrame.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Beside what is seen whole, logical pixels each side.
constexpr double margin = 4.0;

PlaneZoom whole(const Grid& seen, const PlaneAxes& axes, const QSizeF& size) {
  const ReachMm across = reachAlong(seen, axes.right);
  const ReachMm down = reachAlong(seen, axes.down);
  const double width = std::max(1.0, size.width() - 2.0 * margin);
  const double height = std::max(1.0, size.height() - 2.0 * margin);
  return {boxCentreMm(seen),
          std::max((across.last - across.first) / width, (down.last - down.first) / height)};
}

glm::dvec2 pixelAt(const PlaneFrame& frame, const QPointF& point) {
  return glm::dvec2(point.x(), point.y()) * frame.pixelRatio - 0.5;
}

} // namespace

PlaneFrame planeFrame(const Grid& seen, PatientPlane plane, const glm::dvec3& throughMm, const QSizeF& size,
                      double pixelRatio, const std::optional<PlaneZoom>& zoom) {
  PlaneFrame frame;
  frame.pixelRatio = pixelRatio;
  PlaneGrid& grid = frame.grid;
  grid.axes = axesOf(plane);
  grid.size = {std::max(1, static_cast<int>(std::lround(size.width() * pixelRatio))),
               std::max(1, static_cast<int>(std::lround(size.height() * pixelRatio)))};
  const PlaneZoom shown = zoom.value_or(whole(seen, grid.axes, size));
  grid.spacingMm = shown.mmPerPixel / pixelRatio;
  const glm::dvec3 middle =
      shown.centreMm + glm::dot(throughMm - shown.centreMm, grid.axes.forward) * grid.axes.forward;
  const glm::dvec2 half = (glm::dvec2(grid.size) - 1.0) / 2.0;
  grid.originMm = middle - grid.spacingMm * (half.x * grid.axes.right + half.y * grid.axes.down);
  return frame;
}

QPointF pointOf(const PlaneFrame& frame, const glm::dvec3& worldMm) {
  const glm::dvec2 point = (worldToPixel(frame.grid, worldMm) + 0.5) / frame.pixelRatio;
  return {point.x, point.y};
}

glm::dvec3 worldAt(const PlaneFrame& frame, const QPointF& point) {
  return pixelToWorld(frame.grid, pixelAt(frame, point));
}

double mmPerLogicalPixel(const PlaneFrame& frame) {
  return frame.grid.spacingMm * frame.pixelRatio;
}

PlaneZoom zoomedAbout(const PlaneFrame& frame, const QPointF& point, double factor) {
  const double before = mmPerLogicalPixel(frame);
  const double mm = std::clamp(before / factor, 0.01, 1000.0);
  const glm::dvec3 fixed = worldAt(frame, point);
  const glm::dvec3 middle = pixelToWorld(frame.grid, (glm::dvec2(frame.grid.size) - 1.0) / 2.0);
  return {fixed + (middle - fixed) * (mm / before), mm};
}

PlaneZoom pannedBy(const PlaneFrame& frame, const QPointF& moved) {
  const double mm = mmPerLogicalPixel(frame);
  const glm::dvec3 middle = pixelToWorld(frame.grid, (glm::dvec2(frame.grid.size) - 1.0) / 2.0);
  return {middle - mm * (moved.x() * frame.grid.axes.right + moved.y() * frame.grid.axes.down), mm};
}

} // namespace limn
