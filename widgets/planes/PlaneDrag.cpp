// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneDrag.h"

#include "planes/GreyWindows.h"
#include "widgets/planes/PlaneOverlay.h"

#include <QLineF>

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

constexpr double reachOfEnd = 9.0; // logical pixels

PlaneDrag::Kind kindOf(PlaneTool tool) {
  switch (tool) {
  case PlaneTool::crosshair:
    return PlaneDrag::Kind::crosshair;
  case PlaneTool::windowLevel:
    return PlaneDrag::Kind::windowLevel;
  case PlaneTool::distance:
    return PlaneDrag::Kind::distanceTo;
  }
  return PlaneDrag::Kind::crosshair;
}

std::optional<PlaneDrag::Kind> kindOf(const PlanePress& press, const PlaneContent& content,
                                      const PlaneFrame& frame) {
  using Kind = PlaneDrag::Kind;
  if (press.button == Qt::MiddleButton)
    return Kind::pan;
  if (press.button == Qt::RightButton)
    return Kind::windowLevel;
  if (press.button != Qt::LeftButton)
    return std::nullopt;
  if (press.modifiers & Qt::ShiftModifier)
    return Kind::pan;
  if (press.modifiers & Qt::AltModifier)
    return Kind::windowLevel;
  if (const auto end = distanceEndAt(content, press.plane, frame, press.point))
    return end;
  return kindOf(press.tool);
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

std::optional<PlaneDrag> dragFrom(const PlanePress& press, const PlaneContent& content,
                                  const PlaneFrame& frame) {
  const std::optional<PlaneDrag::Kind> kind = kindOf(press, content, frame);
  if (!kind)
    return std::nullopt;
  PlaneDrag drag{*kind, press.button, press.point, content.settings, content, frame};
  const bool takesAnEnd = distanceEndAt(content, press.plane, frame, press.point).has_value();
  if (*kind == PlaneDrag::Kind::distanceTo && !takesAnEnd) {
    const glm::dvec3 place = worldAt(frame, press.point);
    drag.content.settings.distance = MeasuredDistance{press.plane, place, place};
  }
  return drag;
}

std::optional<PlaneSettings> settingsAfter(const PlaneDrag& drag, const QPointF& point) {
  const glm::dvec3 place = worldAt(drag.frame, point);
  const QPointF moved = point - drag.press;
  PlaneSettings settings = drag.content.settings;
  switch (drag.kind) {
  case PlaneDrag::Kind::crosshair:
    return withCrosshair(drag.content, place);
  case PlaneDrag::Kind::windowLevel:
    settings.window =
        rounded(windowDragged(windowOf(drag.content), drag.content.volume->range(), moved.x(), -moved.y()));
    return settings;
  case PlaneDrag::Kind::distanceFrom:
    settings.distance->from = place;
    return settings;
  case PlaneDrag::Kind::distanceTo:
    settings.distance->to = place;
    return settings;
  case PlaneDrag::Kind::pan:
    break;
  }
  return std::nullopt;
}

std::optional<PlaneDrag::Kind> distanceEndAt(const PlaneContent& content, PatientPlane plane,
                                             const PlaneFrame& frame, const QPointF& point) {
  const std::optional<MeasuredDistance>& distance = content.settings.distance;
  if (!distance || !isInSlice(content, plane, *distance))
    return std::nullopt;
  const double from = QLineF(pointOf(frame, distance->from), point).length();
  const double to = QLineF(pointOf(frame, distance->to), point).length();
  if (std::min(from, to) > reachOfEnd)
    return std::nullopt;
  return to <= from ? PlaneDrag::Kind::distanceTo : PlaneDrag::Kind::distanceFrom;
}

} // namespace limn
