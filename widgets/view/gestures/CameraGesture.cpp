// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/CameraGesture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn {
namespace {

double angleAbout(const QPointF& centre, const QPointF& point) {
  return std::atan2(point.y() - centre.y(), point.x() - centre.x());
}

// The shorter way round, so that crossing the negative axis is no full turn.
double wrapped(double angle) {
  return std::remainder(angle, 2.0 * std::numbers::pi);
}

DragKind dragOfTool(ViewTool tool) {
  switch (tool) {
  case ViewTool::rotate:
    return DragKind::rotate;
  case ViewTool::pan:
    return DragKind::pan;
  case ViewTool::zoom:
    return DragKind::zoom;
  case ViewTool::windowLevel:
    return DragKind::windowLevel;
  }
  return DragKind::none;
}

} // namespace

DragKind dragKind(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, ViewTool tool) {
  if (button == Qt::MiddleButton)
    return DragKind::pan;
  if (button == Qt::RightButton)
    return DragKind::zoom;
  if (button != Qt::LeftButton)
    return DragKind::none;
  const bool ctrl = modifiers & Qt::ControlModifier;
  const bool alt = modifiers & Qt::AltModifier;
  if (ctrl && alt)
    return DragKind::opacity;
  if (alt)
    return DragKind::windowLevel;
  if (ctrl)
    return DragKind::roll;
  return modifiers & Qt::ShiftModifier ? DragKind::pan : dragOfTool(tool);
}

Camera dragged(const Camera& camera, DragKind kind, const QPointF& from, const QPointF& to,
               const QRectF& side) {
  const double height = std::max(1.0, side.height());
  const QPointF moved = to - from;
  switch (kind) {
  case DragKind::rotate: {
    const double perPixel = std::numbers::pi / height;
    return orbited(camera, -moved.x() * perPixel, -moved.y() * perPixel);
  }
  case DragKind::pan:
    return panned(camera, moved.x() / height, -moved.y() / height);
  case DragKind::zoom:
    return zoomed(camera, std::exp(-2.0 * moved.y() / height));
  case DragKind::roll:
    return rolled(camera, wrapped(angleAbout(side.center(), to) - angleAbout(side.center(), from)));
  case DragKind::none:
  case DragKind::windowLevel:
  case DragKind::opacity:
  case DragKind::wipe:
  case DragKind::cropFace:
    break;
  }
  return camera;
}

Camera wheelZoomed(const Camera& camera, int angleDelta) {
  return zoomed(camera, std::pow(1.2, angleDelta / 120.0));
}

StandardView nearestStandardView(const Camera& camera) {
  // LPS: looking along +y shows the patient's front, along -x the left side, along -z the top.
  const glm::dvec3 forward = basisOf(camera).forward;
  const glm::dvec3 size = glm::abs(forward);
  if (size.y >= size.x && size.y >= size.z)
    return forward.y > 0.0 ? StandardView::anterior : StandardView::posterior;
  if (size.x >= size.z)
    return forward.x < 0.0 ? StandardView::left : StandardView::right;
  return forward.z < 0.0 ? StandardView::superior : StandardView::inferior;
}

} // namespace limn
