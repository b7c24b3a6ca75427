// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/function/TransferFunction.h"
#include "scene/view/Camera.h"
#include "scene/volume/Volume.h"
#include "widgets/Gesture.h"
#include "widgets/view/overlay/CropBoxOverlay.h"
#include "widgets/view/overlay/ViewGeometry.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <QPointF>
#include <QRectF>
#include <Qt>

#include <optional>
#include <variant>

namespace limn {

/// What the left button does without modifiers. Scissors draw a line to cut along; with `piece`, a click
/// picks the connected piece that is seen there, and a drag rotates. With those that measure a click sets a
/// place that is seen (of an ellipse, which lies in slices alone, it only asks), and a drag rotates where it
/// draws no measurement (MeasureInput); they are in the order of Measurement::Kind.
enum class ViewTool { rotate, pan, zoom, windowLevel, scissors, piece, distance, angle, ellipse, mark };

/// Whether a button that went down and up at these places, logical pixels, clicked and did not drag.
bool isClick(const QPointF& from, const QPointF& to);

/// What a tool measures, where it does, and the tool that measures so.
std::optional<Measurement::Kind> kindOf(ViewTool tool);
ViewTool viewToolOf(Measurement::Kind kind);

/// What a drag in the 3D view does; the last two follow from where it begins.
enum class DragKind { none, rotate, pan, zoom, roll, windowLevel, opacity, wipe, cropFace };

/// The meaning of a pressed button with its modifiers: left rotates (or does what `tool` says), middle and
/// Shift+left pan, right zooms, Ctrl+left rolls, Alt+left is window/level, Ctrl+Alt+left opacity. With the
/// window/level tool Ctrl+Alt still means opacity.
DragKind dragKind(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, ViewTool tool);

/// The camera after the pointer went from `from` to `to` over a picture that fills `side` (logical pixels, y
/// down). Rotation is a half turn per picture height about the picture's own axes; panning keeps the target
/// plane under the pointer; zooming is e² per picture height, up is nearer; rolling follows the pointer
/// around the picture's centre. Kinds that are no camera movement leave it as it is.
/// Rotation goes about `turnsAbout`, world mm, where there is one, and otherwise about the target.
Camera dragged(const Camera& camera, DragKind kind, const QPointF& from, const QPointF& to,
               const QRectF& side, const std::optional<glm::dvec3>& turnsAbout = {});

/// As `orbited` turns, but about a place of the world instead of the target: that place keeps its pixel, and
/// the target turns about it, too. Without a place: `orbited`.
Camera orbitedAbout(const Camera& camera, double yaw, double pitch, const std::optional<glm::dvec3>& placeMm);

/// The camera after the wheel turned by `angleDelta` (eighths of a degree, as Qt counts; a notch is 120):
/// a fifth nearer per notch away from the user.
Camera wheelZoomed(const Camera& camera, int angleDelta);

/// The same towards the pointer over a picture that fills `side`: what lies under it in the target's plane
/// stays there.
Camera wheelZoomed(const Camera& camera, int angleDelta, const QPointF& pointer, const QRectF& side);

/// The standard view that looks most nearly where the camera looks.
StandardView nearestStandardView(const Camera& camera);

/// The window of a transfer function: the values between its outermost points.
struct FunctionWindow {
  double level = 0.0; ///< the middle, scalar units
  double width = 0.0; ///< ≥ 0
};

/// The window of a function; that of `range` where the function has no two different values.
FunctionWindow windowOf(const TransferFunction& function, const ValueRange& range);

/// The function after a window/level drag of `moved` logical pixels (y down) from where the drag began:
/// 256 pixels to the right widen it e-fold about its middle, 256 pixels up raise it by its whole width (the
/// width before the drag). Always computed from the function at the start, so that dragging back undoes.
TransferFunction windowLevelDragged(const TransferFunction& start, const ValueRange& range,
                                    const QPointF& moved);

/// The function after an opacity drag: 100 pixels up double every opacity. Zero stays zero.
TransferFunction opacityDragged(const TransferFunction& start, const QPointF& moved);

/// Where the border of the wipe should lie, as a fraction of the width.
struct WipeTo {
  double fraction = 0.5;
  bool operator==(const WipeTo&) const = default;
};

/// What a gesture asks to be shown instead of what is; nothing where it changes nothing.
using ViewEdit = std::variant<std::monostate, Camera, TransferFunction, CropBox, WipeTo>;

/// What a press asks for that is released where it began.
enum class ViewClick { none, pin, turnAbout, menu, pick, measure, cube };

/// A pressed button until its release; places in logical pixels.
struct ViewDrag {
  DragKind kind = DragKind::none;
  Qt::MouseButton button = Qt::NoButton;
  ViewClick click = ViewClick::none; ///< until it moves
  QPointF first, last;
  QRectF picture;                       ///< in which it began
  double viewWidth = 1;                 ///< ≥ 1
  Scene before;                         ///< what was shown when it began
  CropFace face;                        ///< of the crop box, where that is dragged
  TurnedBox box;                        ///< that box, as it was
  QPointF grip;                         ///< from the handle's centre to the pointer
  std::optional<glm::dvec3> turnsAbout; ///< world, before the eye; absent: the target
  Gesture gesture;
};

/// A button that goes down.
struct Press {
  Qt::MouseButton button = Qt::NoButton;
  Qt::KeyboardModifiers modifiers;
  QPointF point; ///< logical pixels
};

/// The drag that a press begins: of the handle under it, if it takes hold of one, of the border of the wipe,
/// or what button, modifiers and tool make of it.
ViewDrag dragFrom(const Press& press, const Comparison& comparison, const ViewGeometry& geometry,
                  ViewTool tool, const std::optional<CropHandle>& handle);

/// What the drag makes of `shown` once the pointer is at `point`, which it notes.
ViewEdit editAt(ViewDrag& drag, const Scene& shown, const QPointF& point);

/// What puts back all that the drag has changed.
ViewEdit undone(const ViewDrag& drag, const Scene& shown);

} // namespace limn
