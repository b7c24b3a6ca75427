// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneDrag.h"

#include "planes/GreyWindows.h"
#include "widgets/planes/PlaneMeasures.h"

#include <QLineF>

#include <algorithm>
#include <array>
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

PlaneDrag::Kind dragOf(PlaneTool tool) {
  return tool == PlaneTool::windowLevel ? PlaneDrag::Kind::windowLevel
         : kindOf(tool)                 ? PlaneDrag::Kind::measure
                                        : PlaneDrag::Kind::crosshair;
}

std::optional<PlaneDrag::Kind> dragOf(const PlanePress& press, bool isOnHandle) {
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
  return isOnHandle ? Kind::measure : dragOf(press.tool);
}

// A mark is led from where it begins, of the others the second place.
std::size_t firstHandle(Measurement::Kind kind) {
  return kind == Measurement::Kind::mark ? 0 : kind == Measurement::Kind::ellipse ? ellipseCorner : 1;
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

// Of pixels that lie 1 / `scale` as far apart, about the same middle.
static PlaneGrid drawnAnew(PlaneGrid grid, const glm::ivec2& size, double scale) {
  const auto place = [&grid](const glm::dvec2& pixel) {
    return grid.originMm + grid.spacingMm * (pixel.x * grid.axes.right + pixel.y * grid.axes.down);
  };
  const glm::dvec3 middle = place((glm::dvec2(grid.size) - 1.0) / 2.0);
  grid.size = size;
  grid.spacingMm /= scale;
  const glm::dvec2 half = (glm::dvec2(grid.size) - 1.0) / 2.0;
  grid.originMm = middle - grid.spacingMm * (half.x * grid.axes.right + half.y * grid.axes.down);
  return grid;
}

PlaneFrame scaledBy(PlaneFrame frame, double scale) {
  if (scale == 1.0)
    return frame; // to the bit
  const glm::ivec2 size = glm::max(glm::ivec2(glm::round(glm::dvec2(frame.grid.size) * scale)), 1);
  frame.grid = drawnAnew(frame.grid, size, scale);
  frame.pixelRatio *= scale;
  return frame;
}

PlaneFrame shapedAs(PlaneFrame frame, const glm::ivec2& size) {
  const glm::dvec2 scale = glm::dvec2(size) / glm::dvec2(frame.grid.size);
  frame.grid = drawnAnew(frame.grid, size, scale.y);
  frame.pixelRatio *= std::max(scale.x, scale.y);
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

bool cuts(PlaneTool tool) {
  return tool == PlaneTool::scissors || tool == PlaneTool::piece;
}

std::optional<Measurement::Kind> kindOf(PlaneTool tool) {
  if (tool < PlaneTool::distance)
    return std::nullopt;
  return measurementKinds[static_cast<std::size_t>(tool) - static_cast<std::size_t>(PlaneTool::distance)];
}

PlaneTool toolOf(Measurement::Kind kind) {
  return static_cast<PlaneTool>(static_cast<int>(PlaneTool::distance) + static_cast<int>(kind));
}

std::optional<PlaneTool> toolOfKey(int key) {
  constexpr std::array keys{Qt::Key_C, Qt::Key_W, Qt::Key_X, Qt::Key_K,
                            Qt::Key_D, Qt::Key_G, Qt::Key_E, Qt::Key_N}; // in the order of PlaneTool
  const auto found = std::ranges::find(keys, key);
  return found == keys.end() ? std::nullopt : std::optional(static_cast<PlaneTool>(found - keys.begin()));
}

std::optional<MeasureHandle> handleTaken(const PlaneContent& content, PatientPlane plane,
                                         const PlaneFrame& frame, PlaneTool tool, const QPointF& point) {
  if (cuts(tool))
    return std::nullopt;
  const std::optional<MeasureHandle> handle = measureHandleAt(measureShapes(content, plane, frame), point);
  const std::optional<Measurement::Kind> makes = kindOf(tool);
  const bool isTaken = handle && (!makes || content.measured[handle->number].measurement.kind == *makes);
  return isTaken ? handle : std::nullopt;
}

std::optional<PlaneDrag> dragFrom(const PlanePress& press, const PlaneContent& content,
                                  const PlaneFrame& frame) {
  const std::optional<MeasureHandle> handle =
      handleTaken(content, press.plane, frame, press.tool, press.point);
  const std::optional<PlaneDrag::Kind> kind = dragOf(press, handle.has_value());
  if (!kind)
    return std::nullopt;
  PlaneDrag drag{*kind, press.button, press.point, content.settings, content, frame};
  if (*kind != PlaneDrag::Kind::measure)
    return drag;
  drag.gesture.id = nextGestureId();
  drag.measurements = measurementsOf(content.measured);
  if (handle) {
    drag.handle = *handle;
    return drag;
  }
  drag.isNew = true;
  drag.measurements.push_back(
      begunAt(*kindOf(press.tool), press.plane, worldAt(frame, press.point), content.measured));
  drag.handle = {drag.measurements.size() - 1, firstHandle(drag.measurements.back().kind)};
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
  case PlaneDrag::Kind::measure:
  case PlaneDrag::Kind::pan:
    break;
  }
  return std::nullopt;
}

MeasurementsEdited measuredAfter(const PlaneDrag& drag, const QPointF& point) {
  std::vector<Measurement> measurements = drag.measurements;
  Measurement& led = measurements[drag.handle.number];
  led = withHandleAt(led, drag.handle.place, worldAt(drag.frame, point), drag.isNew);
  const std::size_t place = drag.handle.place == ellipseCorner ? 1 : drag.handle.place;
  return {std::move(measurements), drag.handle.number, drag.gesture,
          drag.isNew ? std::optional(place) : std::nullopt};
}

MeasurementsEdited measuredAtRelease(PlaneDrag& drag, const QPointF& point) {
  using Kind = Measurement::Kind;
  MeasurementsEdited edited = measuredAfter(drag, point);
  const Kind kind = drag.measurements.back().kind;
  const bool isClick = QLineF(drag.press, point).length() < shortestDrag;
  const bool isLastPlace = kind == Kind::mark || (kind == Kind::angle && drag.handle.place == 2);
  drag.isLoose = !isLastPlace && (isClick || kind == Kind::angle);
  if (drag.isLoose && !isClick) {
    drag.measurements = edited.measurements;
    drag.handle.place = 2;
  }
  edited.next = drag.isLoose ? measuredAfter(drag, point).next : std::nullopt;
  return edited;
}

MeasurementsEdited measuredBefore(const PlaneDrag& drag) {
  return {measurementsOf(drag.content.measured), drag.content.inHand, drag.gesture};
}

} // namespace limn
