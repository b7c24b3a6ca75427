// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/OrientationMarks.h"

#include <QFont>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <vector>

class QPainter;

namespace limn {

/// Between what stands above the pictures and the edge of the view, logical pixels.
inline constexpr double overlayMargin = 12.0;

/// In a lower picture titles and sides alone have room beside what is shown, logical pixels.
inline constexpr double leastHeightForNotes = 130.0;

/// The name of a side and the numbers that matter, in the side's upper left corner. The numbers fade.
struct SideLabel {
  QString title;
  QStringList details; ///< the most important first; where there is little room the last ones are left out
  double detailsOpacity = 1.0; ///< 0..1
  bool hovered = false;
  bool leadsToMenu = true; ///< shows that a click changes the model
};

/// The title of a label as it stands on its plate: one that is too long is shortened in its middle.
QString fittingTitle(const QFont& font, const SideLabel& label, const QRectF& plate);

/// As many details as have room in so many logical pixels, in one line.
QString fittingDetails(const QFont& font, const QStringList& details, double room);

/// The plate of a label at the upper edge of `side`, logical pixels: left, centred or right.
QRectF labelPlate(const QFont& font, const SideLabel& label, const QRectF& side, Qt::Alignment alignment);

/// A small line of text on a plate of its own.
struct Note {
  QString text;
  QRectF plate;
  QString whole{}; ///< before it was shortened
};

/// A note with its lower right, lower centre or lower left at `corner`; text that is wider than `room` is
/// shortened.
Note noteAt(const QFont& font, const QString& text, const QPointF& corner, Qt::Alignment alignment,
            double room);

/// The plate of a scale bar in the lower left corner of `side`.
QRectF scaleBarPlate(const QFont& font, const ScaleBar& bar, const QString& text, const QRectF& side);

/// A scale bar with its text and plate.
struct ScaleMark {
  ScaleBar bar;
  QString text;
  QRectF plate;
};

/// What the colours of a signed difference mean: a strip from one end to the other with three numbers below.
struct DifferenceBar {
  QString lowest, middle, highest; ///< "−64", "0", "+64 levels"
  QString leftBrighter, rightBrighter;
  QRectF plate;
};

/// The plate of such a bar with its lower right corner at `corner`.
QRectF differenceBarPlate(const QFont& font, const DifferenceBar& bar, const QPointF& corner);

/// The fonts of titles and letters, made of the overlay's.
QFont titleFont(const QFont& font);

/// Paints the parts of the overlay, all in logical pixels; text stands on dark plates and stays legible on
/// any picture.
void paintLabel(QPainter& painter, const SideLabel& label, const QRectF& plate);
void paintScaleBar(QPainter& painter, const ScaleMark& mark);
void paintProgress(QPainter& painter, double fraction, const QRectF& view);
/// How the border of a wipe is drawn: its knob belongs to who can drag it.
struct WipeBorderLook {
  bool isHovered = false;
  bool hasKnob = true;
};
void paintWipeBorder(QPainter& painter, double x, const QRectF& view, const WipeBorderLook& look);
/// Marks a place that slices show, too.
void paintMark(QPainter& painter, const QPointF& point);
/// The same where what is seen lies before the place: a ring of dashes.
void paintHiddenMark(QPainter& painter, const QPointF& point);
/// Marks where half of a ray's light is gathered: a diamond with "½" beside it.
void paintHalfMark(QPainter& painter, const QPointF& point);
/// Marks the place about which a picture is turned: a dot in a ring that is open as an arrow is.
void paintTurnMark(QPainter& painter, const QPointF& point);
/// Marks the probed point and tells its value.
void paintProbe(QPainter& painter, const QPointF& point, const QString& text, const QRectF& view);
void paintNote(QPainter& painter, const Note& note);
void paintDifferenceBar(QPainter& painter, const DifferenceBar& bar);
/// The dark ground of texts; and text that stands without one.
void paintPlate(QPainter& painter, const QRectF& plate);
void paintOutlined(QPainter& painter, const QRectF& place, const QString& text);

/// Where texts of `size` that stand at one height on all sides of a view keep clear of the plates of the
/// overlay. `columns` are the horizontal centres of the texts; all in logical pixels, y down. Sides that are
/// compared must look alike, so where one text has to yield all do.

/// The upper edge of the texts: at `top`, or as little below it as the plates allow.
double clearRowBelow(double top, const QSizeF& size, const std::vector<double>& columns,
                     const std::vector<QRectF>& plates);

/// The lower edge of the texts: at `bottom`, or as little above it as the plates allow.
double clearRowAbove(double bottom, const QSizeF& size, const std::vector<double>& columns,
                     const std::vector<QRectF>& plates);

} // namespace limn
