// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/ViewDrag.h"

#include "widgets/view/overlay/OrientationMarks.h"

#include <QObject>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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
  case ViewTool::piece:
  case ViewTool::distance:
  case ViewTool::angle:
  case ViewTool::ellipse:
  case ViewTool::mark:
    return DragKind::rotate;
  case ViewTool::scissors:
    break;
  }
  return DragKind::none;
}

ViewClick clickOf(const Press& press, ViewTool tool) {
  if (tool == ViewTool::piece && press.button == Qt::LeftButton && press.modifiers == Qt::NoModifier)
    return ViewClick::pick;
  if (kindOf(tool) && press.button == Qt::LeftButton && press.modifiers == Qt::NoModifier)
    return ViewClick::measure;
  if (press.button == Qt::RightButton && press.modifiers == Qt::NoModifier)
    return ViewClick::menu;
  if (press.modifiers != Qt::ShiftModifier)
    return ViewClick::none;
  return press.button == Qt::LeftButton     ? ViewClick::pin
         : press.button == Qt::MiddleButton ? ViewClick::turnAbout
                                            : ViewClick::none;
}

QString textOf(const ViewDrag& drag) {
  if (drag.kind == DragKind::cropFace && drag.box.grid != drag.before.volume->grid())
    return QObject::tr("turned box: move %1 face")
        .arg(turnedFaceName(drag.box, *drag.before.volume, drag.face));
  if (drag.kind == DragKind::cropFace)
    return QObject::tr("move crop face: %1").arg(cropFaceName(*drag.before.volume, drag.face));
  return drag.kind == DragKind::opacity ? QObject::tr("change opacity")
                                        : QObject::tr("change window and level");
}

// Only what differs from what is shown is worth asking for.
template <class Value>
ViewEdit unlessShown(const Value& wanted, const Value& shown) {
  return wanted == shown ? ViewEdit() : ViewEdit(wanted);
}

CropBox croppedTo(const ViewDrag& drag, const Scene& shown, const QPointF& point) {
  const Grid& grid = drag.box.grid;
  const CropBox& crop = drag.box.crop;
  const ViewProjection projection = viewProjection(shown.camera, drag.picture);
  const double place = placeUnder(crop, grid, drag.face, projection, point - drag.grip);
  return withFaceAt(crop, grid, drag.face, place);
}

} // namespace

bool isClick(const QPointF& from, const QPointF& to) {
  constexpr double clickSlack = 3.0; // it may tremble by this many logical pixels
  return std::hypot(to.x() - from.x(), to.y() - from.y()) <= clickSlack;
}

std::optional<Measurement::Kind> kindOf(ViewTool tool) {
  if (tool < ViewTool::distance)
    return std::nullopt;
  return measurementKinds[static_cast<std::size_t>(tool) - static_cast<std::size_t>(ViewTool::distance)];
}

ViewTool viewToolOf(Measurement::Kind kind) {
  return static_cast<ViewTool>(static_cast<int>(ViewTool::distance) + static_cast<int>(kind));
}

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
               const QRectF& side, const std::optional<glm::dvec3>& turnsAbout) {
  const double height = std::max(1.0, side.height());
  const QPointF moved = to - from;
  switch (kind) {
  case DragKind::rotate: {
    const double perPixel = std::numbers::pi / height;
    return orbitedAbout(camera, -moved.x() * perPixel, -moved.y() * perPixel, turnsAbout);
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

Camera orbitedAbout(const Camera& camera, double yaw, double pitch,
                    const std::optional<glm::dvec3>& placeMm) {
  Camera moved = orbited(camera, yaw, pitch);
  if (!placeMm)
    return moved;
  const CameraBasis before = basisOf(camera);
  const CameraBasis after = basisOf(moved);
  const auto turned = [&](const glm::dvec3& arm) {
    return after.right * glm::dot(before.right, arm) + after.up * glm::dot(before.up, arm) +
           after.forward * glm::dot(before.forward, arm);
  };
  moved.position = *placeMm + turned(camera.position - *placeMm);
  moved.target = *placeMm + turned(camera.target - *placeMm);
  return moved;
}

Camera wheelZoomed(const Camera& camera, int angleDelta) {
  return zoomed(camera, std::pow(1.2, angleDelta / 120.0));
}

Camera wheelZoomed(const Camera& camera, int angleDelta, const QPointF& pointer, const QRectF& side) {
  const double factor = std::pow(1.2, angleDelta / 120.0);
  const QPointF fromCentre = (pointer - side.center()) / std::max(1.0, side.height());
  return panned(zoomed(camera, factor), (1.0 - factor) * fromCentre.x(), (factor - 1.0) * fromCentre.y());
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

FunctionWindow windowOf(const TransferFunction& function, const ValueRange& range) {
  double lowest = range.lowest;
  double highest = range.highest;
  if (!function.points.empty() && function.points.front().value < function.points.back().value) {
    lowest = function.points.front().value;
    highest = function.points.back().value;
  }
  return {0.5 * (lowest + highest), highest - lowest};
}

TransferFunction windowLevelDragged(const TransferFunction& start, const ValueRange& range,
                                    const QPointF& moved) {
  const FunctionWindow window = windowOf(start, range);
  // A factor beyond e^±6 only collapses the points or sends them out of every volume's range.
  const double factor = std::exp(std::clamp(moved.x() / 256.0, -6.0, 6.0));
  const double offset = -moved.y() / 256.0 * window.width;
  return shifted(stretched(start, window.level, factor), offset);
}

TransferFunction opacityDragged(const TransferFunction& start, const QPointF& moved) {
  return withOpacityScaled(start, std::exp2(std::clamp(-moved.y() / 100.0, -20.0, 20.0)));
}

ViewDrag dragFrom(const Press& press, const Comparison& comparison, const ViewGeometry& geometry,
                  ViewTool tool, const std::optional<CropHandle>& handle) {
  ViewDrag drag;
  drag.button = press.button;
  drag.first = drag.last = press.point;
  drag.picture = pictureRect(geometry, standingAt(geometry, press.point));
  drag.viewWidth = std::max(1, geometry.size.width());
  drag.before = comparison.scene;
  drag.turnsAbout = centreBeforeEye(comparison.scene.camera, comparison.turnsAboutMm);
  if (handle) {
    drag.kind = DragKind::cropFace;
    drag.face = handle->face;
    drag.box = boxOver(comparison);
    drag.grip = press.point - handle->centre;
  } else {
    const bool isLeft = press.button == Qt::LeftButton;
    drag.kind = isLeft && isOnWipeBorder(geometry, press.point)
                    ? DragKind::wipe
                    : dragKind(press.button, press.modifiers, tool);
    drag.click = clickOf(press, tool);
  }
  drag.gesture = {nextGestureId(), textOf(drag)};
  return drag;
}

ViewEdit editAt(ViewDrag& drag, const Scene& shown, const QPointF& point) {
  if (drag.kind == DragKind::wipe)
    return WipeTo{point.x() / drag.viewWidth};
  const QPointF moved = point - drag.first;
  if (drag.click != ViewClick::none && isClick(drag.first, point))
    return {};
  drag.click = ViewClick::none;
  const TransferFunction& function = drag.before.transferFunction;
  switch (drag.kind) {
  case DragKind::cropFace:
    return drag.box.grid == shown.volume->grid() ? unlessShown(croppedTo(drag, shown, point), shown.crop)
                                                 : ViewEdit(croppedTo(drag, shown, point));
  case DragKind::opacity:
    return unlessShown(opacityDragged(function, moved), shown.transferFunction);
  case DragKind::windowLevel:
    return unlessShown(windowLevelDragged(function, shown.volume->range(), moved), shown.transferFunction);
  default:
    return unlessShown(dragged(shown.camera, drag.kind, std::exchange(drag.last, point), point, drag.picture,
                               drag.turnsAbout),
                       shown.camera);
  }
}

ViewEdit undone(const ViewDrag& drag, const Scene& shown) {
  switch (drag.kind) {
  case DragKind::wipe:
    return WipeTo{drag.first.x() / drag.viewWidth};
  case DragKind::cropFace:
    return drag.box.grid == shown.volume->grid() ? unlessShown(drag.box.crop, shown.crop)
                                                 : ViewEdit(drag.box.crop);
  case DragKind::opacity:
  case DragKind::windowLevel:
    return unlessShown(drag.before.transferFunction, shown.transferFunction);
  default:
    return unlessShown(drag.before.camera, shown.camera);
  }
}

} // namespace limn
