// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/ViewDrag.h"

#include "widgets/properties/AxisNames.h"
#include "widgets/view/gestures/WindowLevelGesture.h"

#include <QObject>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

constexpr double clickSlack = 3.0; // a click may tremble by this many logical pixels

QString textOf(const ViewDrag& drag) {
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
  const Grid& grid = shown.volume->grid();
  const ViewProjection projection = viewProjection(shown.camera, drag.picture);
  const double place = placeUnder(drag.before.crop, grid, drag.face, projection, point - drag.grip);
  return withFaceAt(drag.before.crop, grid, drag.face, place);
}

} // namespace

ViewDrag dragFrom(const Press& press, const Comparison& comparison, const ViewGeometry& geometry,
                  ViewTool tool, const std::optional<CropHandle>& handle) {
  ViewDrag drag;
  drag.button = press.button;
  drag.first = drag.last = press.point;
  drag.picture = pictureRect(geometry, standingAt(geometry, press.point));
  drag.viewWidth = std::max(1, geometry.size.width());
  drag.before = comparison.scene;
  if (handle) {
    drag.kind = DragKind::cropFace;
    drag.face = handle->face;
    drag.grip = press.point - handle->centre;
  } else {
    const bool isLeft = press.button == Qt::LeftButton;
    drag.kind = isLeft && isOnWipeBorder(geometry, press.point)
                    ? DragKind::wipe
                    : dragKind(press.button, press.modifiers, tool);
    drag.mayPin = isLeft && press.modifiers == Qt::ShiftModifier;
  }
  drag.gesture = {nextGestureId(), textOf(drag)};
  return drag;
}

ViewEdit editAt(ViewDrag& drag, const Scene& shown, const QPointF& point) {
  if (drag.kind == DragKind::wipe)
    return WipeTo{point.x() / drag.viewWidth};
  const QPointF moved = point - drag.first;
  if (drag.mayPin && std::hypot(moved.x(), moved.y()) <= clickSlack)
    return {};
  drag.mayPin = false;
  const TransferFunction& function = drag.before.transferFunction;
  switch (drag.kind) {
  case DragKind::cropFace:
    return unlessShown(croppedTo(drag, shown, point), shown.crop);
  case DragKind::opacity:
    return unlessShown(opacityDragged(function, moved), shown.transferFunction);
  case DragKind::windowLevel:
    return unlessShown(windowLevelDragged(function, shown.volume->range(), moved), shown.transferFunction);
  default:
    return unlessShown(dragged(shown.camera, drag.kind, std::exchange(drag.last, point), point, drag.picture),
                       shown.camera);
  }
}

ViewEdit undone(const ViewDrag& drag, const Scene& shown) {
  switch (drag.kind) {
  case DragKind::wipe:
    return WipeTo{drag.first.x() / drag.viewWidth};
  case DragKind::cropFace:
    return unlessShown(drag.before.crop, shown.crop);
  case DragKind::opacity:
  case DragKind::windowLevel:
    return unlessShown(drag.before.transferFunction, shown.transferFunction);
  default:
    return unlessShown(drag.before.camera, shown.camera);
  }
}

} // namespace limn
