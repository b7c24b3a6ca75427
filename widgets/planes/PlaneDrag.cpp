// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneDrag.h"

#include "planes/GreyWindows.h"
#include "widgets/planes/PlaneOverlay.h"

#include <QLineF>

namespace limn {
namespace {

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
