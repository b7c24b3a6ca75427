// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/ViewGeometry.h"

#include <QPointF>
#include <QRectF>

#include <glm/glm.hpp>

#include <vector>

class QPainter;

namespace limn {

/// A line that is drawn on a picture to cut along it, until it is closed. Places are logical pixels of the
/// view. Drawn in one go with the button held, or corner by corner with clicks; each way goes on with the
/// other.
struct CutLine {
  QRectF picture; ///< on which it is drawn
  std::vector<QPointF> corners;
  QPointF pointer;           ///< where the next corner would be
  bool isHeld = false;       ///< the button is down
  bool isByClicks = false;   ///< corners are set one by one: letting go does not close it
  bool isStraight = false;   ///< Shift is held: from the last corner straight to the pointer
  bool removesInside = true; ///< what is cut away: what the line goes around, or all else
  bool operator==(const CutLine&) const = default;
};

/// A line that begins where a button went down.
CutLine lineFrom(const QPointF& point, const QRectF& picture);

/// The button goes down on a line drawn by clicks: true where that closes it, at its first corner.
bool pressLine(CutLine& line, const QPointF& point);

/// The pointer moves, with the button held or not.
void moveLine(CutLine& line, const QPointF& point, bool isStraight);

/// The button comes up: true where that closes the line.
bool releaseLine(CutLine& line, const QPointF& point);

/// Takes the last corner back; false where none is left.
bool shortenLine(CutLine& line);

/// Whether it goes around anything: it has three corners at least that lie apart.
bool isArea(const CutLine& line);

/// The line with the pointer as its last corner, closed: what it would cut along now, logical pixels.
std::vector<QPointF> closedLine(const CutLine& line);

/// Its corners in halves of the picture's height from its middle, y up (DEFINITION section 8), without those
/// that lie on a straight line between their neighbours to a quarter of a pixel.
std::vector<glm::dvec2> polygonOf(const CutLine& line);

/// Paints it over the picture, with what would go as a red veil.
void paintCutLine(QPainter& painter, const CutLine& line);

} // namespace limn
