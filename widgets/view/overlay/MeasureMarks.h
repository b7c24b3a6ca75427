// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Measurement.h"
#include "widgets/view/overlay/OverlayParts.h"

#include <QPointF>

#include <optional>
#include <vector>

class QPainterPath;

namespace limn {

/// How near the pointer is to a handle that it takes, logical pixels.
inline constexpr double measureHandleReach = 9.0;

/// A measurement where it is seen, in logical pixels of a view. Of an ellipse `places` are its left, right,
/// upper and lower end and its middle; of all others the places that were measured, of which the last ones
/// are absent while they are being measured. Each is a handle.
struct MeasureShape {
  std::size_t number = 0; ///< in the list of measurements
  Measurement::Kind kind = Measurement::Kind::distance;
  std::vector<QPointF> places; ///< at least one
  QString text;                ///< empty: none stands beside it
  bool isInHand = false;
  bool isOpen = false;   ///< nothing of it can be taken: it is being measured, or is led elsewhere
  bool isHidden = false; ///< behind what is seen, or in what is cut away: its lines are drawn faintly
};

/// With the place of its text: beside an end and clear of what was measured, with a thin leader.
struct MeasureMark {
  MeasureShape shape;
  std::optional<Note> note;
  QPointF anchor; ///< of the leader
};

/// Gives every text a place in the view where it covers neither what was measured nor one of the plates nor
/// another text; in a view that is full of them, where it covers least.
std::vector<MeasureMark> placedMeasures(const std::vector<MeasureShape>& shapes, const QFont& font,
                                        const QRectF& view, std::vector<QRectF> plates);

/// What a text beside it must not lie on: for a distance what spans as much across as along, up to a limit.
QPainterPath measuredArea(const MeasureShape& shape);

/// Which place of which shape a point takes hold of; of several the nearest.
struct MeasureHandle {
  std::size_t number = 0; ///< of the measurement
  std::size_t place = 0;  ///< of the shape
  bool operator==(const MeasureHandle&) const = default;
};
std::optional<MeasureHandle> measureHandleAt(const std::vector<MeasureShape>& shapes, const QPointF& point);

void paintMeasures(QPainter& painter, const std::vector<MeasureMark>& marks);

} // namespace limn
