// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/curve/picture/CurveEdits.h"
#include "widgets/curve/picture/CurveGeometry.h"

#include <cstdint>
#include <optional>

class QKeyEvent;
class QPointF;
class QWheelEvent;

namespace limn {

class TransferFunctionCanvas;

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

/// Opens the menu of a plot at a place in it: what can be done with the point there or, beside all points, at
/// that place, and with all points. A point that is not in hand comes into it.
void openCurveMenu(TransferFunctionCanvas& canvas, const QPointF& position);

/// A drag under way in the plot.
struct CurveDrag {
  enum class Kind { none, points, shift, width, band, pan };
  Kind kind = Kind::none;
  TransferFunction before;     ///< what the travel applies to
  TransferFunction restored;   ///< what Esc brings back: without the point that the press itself added
  bool added = false;          ///< the press added the grabbed point
  PointIndices moved;          ///< kind points
  std::size_t grabbed = 0;     ///< kind points: the one under the pointer
  PointIndices selectedBefore; ///< kind band
  QPointF press;               ///< pixels
  QPointF last;                ///< pixels: the latest pointer position
  QPointF travelled;           ///< pixels: counts a tenth while Alt is held
  bool isFine = false;         ///< Alt was held at some time
  double pressValue = 0.0;     ///< kind width
  bool fromGrip = false;       ///< kind width: Alt on the grip rather than an end of the bar
  bool started = false;        ///< the pointer left the press by a few pixels
  std::uint64_t gestureId = 0;
};

/// A drag of a kind that begins at a press.
CurveDrag begunDrag(CurveDrag::Kind kind, const TransferFunction& function, const PlotTransform& transform,
                    const QPointF& press);

/// The drag that a press on a point, on the bar or beside everything begins. A point takes all points in hand
/// with it, Alt makes the grip change the width, Ctrl lets a band add to what is in hand.
CurveDrag begunDrag(const CurveHit& hit, const CurvePlot& plot, const PlotTransform& transform,
                    const QPointF& press, Qt::KeyboardModifiers modifiers);

/// Adds a pointer move. `fine` counts it a tenth.
void travel(CurveDrag& drag, const QPointF& position, bool fine);

/// The function as the drag has it now. `lockAxis` keeps the axis along which the drag went less.
TransferFunction draggedFunction(const CurveDrag& drag, const PlotTransform& transform, bool lockAxis);

/// The points in hand with those that a band encloses now.
PointIndices bandedPoints(const CurveDrag& drag, const PlotTransform& transform,
                          const TransferFunction& function);

/// What undo shows: "move point to 310 HU".
QString dragText(const CurveDrag& drag, const TransferFunction& now, const QString& unit, int decimals);

} // namespace limn
