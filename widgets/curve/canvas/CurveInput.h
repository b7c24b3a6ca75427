// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/curve/edits/CurvePlot.h"
#include "widgets/curve/plot/CurveGeometry.h"

#include <optional>

class QKeyEvent;
class QWheelEvent;

namespace limn {

/// What a key asks of the points in hand.
enum class CurveKey { none, selectAll, selectNone, deleteSelected, addPoint, typeNumbers, nudge };

/// `anySelected`: points are in hand.
CurveKey curveKeyOf(const QKeyEvent& event, bool anySelected);

/// Whether a key belongs to the plot rather than to a shortcut of the window.
bool comesBeforeShortcuts(const QKeyEvent& event, bool anySelected);

/// Where an arrow key points, up positive: ten times as far with Shift, a tenth with Alt; null for other
/// keys.
QPointF arrowOf(const QKeyEvent& event);

/// The visible values after a turn of the wheel: zoomed at the pointer or, with Shift, moved; within `full`.
ValueRange wheeledView(const PlotTransform& transform, const QWheelEvent& event, const ValueRange& full);

/// The visible values after a key: Ctrl with + and − zooms about the point in hand or the middle, with arrows
/// moves, with 0 shows all; nothing for other keys.
std::optional<ValueRange> keyedView(const PlotTransform& transform, const QKeyEvent& event,
                                    const CurvePlot& plot);

/// What the pointer looks like over a part of the plot.
Qt::CursorShape cursorFor(CurveHit::Part part);

} // namespace limn
