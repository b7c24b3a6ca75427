// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/curve/plot/CurveGeometry.h"

class QKeyEvent;
class QWheelEvent;

namespace limn {

/// What a key asks of the points in hand.
enum class CurveKey { none, selectAll, selectNone, deleteSelected, typeNumbers, nudge };

/// `anySelected`: points are in hand.
CurveKey curveKeyOf(const QKeyEvent& event, bool anySelected);

/// Whether a key belongs to the plot rather than to a shortcut of the window.
bool comesBeforeShortcuts(const QKeyEvent& event, bool anySelected);

/// Where an arrow key points, up positive: ten times as far with Shift, a tenth with Alt; null for other
/// keys.
QPointF arrowOf(const QKeyEvent& event);

/// The visible values after a turn of the wheel: zoomed at the pointer or, with Shift, moved; within `full`.
ValueRange wheeledView(const PlotTransform& transform, const QWheelEvent& event, const ValueRange& full);

Qt::CursorShape cursorFor(CurveHit::Part part);

} // namespace limn
