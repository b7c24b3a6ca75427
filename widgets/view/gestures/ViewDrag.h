// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"
#include "widgets/view/Comparison.h"
#include "widgets/view/ViewGeometry.h"
#include "widgets/view/gestures/CameraGesture.h"
#include "widgets/view/overlay/CropBoxGeometry.h"

#include <optional>
#include <variant>

namespace limn {

/// Where the border of the wipe should lie, as a fraction of the width.
struct WipeTo {
  double fraction = 0.5;
  bool operator==(const WipeTo&) const = default;
};

/// What a gesture asks to be shown instead of what is; nothing where it changes nothing.
using ViewEdit = std::variant<std::monostate, Camera, TransferFunction, CropBox, WipeTo>;

/// A pressed button until its release; places in logical pixels.
struct ViewDrag {
  DragKind kind = DragKind::none;
  Qt::MouseButton button = Qt::NoButton;
  bool mayPin = false; ///< a Shift+click that has not moved yet
  QPointF first, last;
  QRectF picture;       ///< in which it began
  double viewWidth = 1; ///< ≥ 1
  Scene before;         ///< what was shown when it began
  CropFace face;        ///< of the crop box, where that is dragged
  QPointF grip;         ///< from the handle's centre to the pointer
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
