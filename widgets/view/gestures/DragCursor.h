// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/gestures/CameraGesture.h"

#include <QCursor>

namespace limn {

/// The pointer that tells what a drag of this kind does; the plain arrow for rotating. Seen on light and dark
/// pictures. Needs a QGuiApplication.
QCursor cursorOf(DragKind kind);

} // namespace limn
