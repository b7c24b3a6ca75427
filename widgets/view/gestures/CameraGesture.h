// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

#include <QPointF>
#include <QRectF>
#include <Qt>

namespace limn {

/// What the left button does without modifiers.
enum class ViewTool { rotate, pan, zoom, windowLevel };

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
Camera dragged(const Camera& camera, DragKind kind, const QPointF& from, const QPointF& to,
               const QRectF& side);

/// The camera after the wheel turned by `angleDelta` (eighths of a degree, as Qt counts; a notch is 120):
/// a fifth nearer per notch away from the user.
Camera wheelZoomed(const Camera& camera, int angleDelta);

/// The standard view that looks most nearly where the camera looks.
StandardView nearestStandardView(const Camera& camera);

} // namespace limn
