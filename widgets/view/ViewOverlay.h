// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/OrientationLetters.h"
#include "widgets/view/ScaleBar.h"

#include <QRectF>
#include <QString>

class QFont;
class QPainter;

namespace limn {

/// The name of a side and the numbers that matter, in the side's upper left corner. The numbers fade.
struct SideLabel {
  QString title;
  QString details;
  double detailsOpacity = 1.0; ///< 0..1
  bool hovered = false;
  bool leadsToMenu = true; ///< shows that a click changes the model
};

/// The plate of a label whose side is `side`, logical pixels. A label of the right half of a wipe is aligned
/// to the right (`toTheRight`).
QRectF labelPlate(const QFont& font, const SideLabel& label, const QRectF& side, bool toTheRight);

/// Paints the parts of the overlay, all in logical pixels; text stands on dark plates and stays legible on
/// any picture.
void paintLabel(QPainter& painter, const SideLabel& label, const QRectF& plate);
/// The upper letter keeps clear of `labelBottom`; the upper and lower ones stand at `column`.
void paintLetters(QPainter& painter, const OrientationLetters& letters, const QRectF& side, double column,
                  double labelBottom);
void paintScaleBar(QPainter& painter, const ScaleBar& bar, const QString& text, const QRectF& side);
void paintProgress(QPainter& painter, double fraction, const QRectF& view);
void paintWipeBorder(QPainter& painter, double x, const QRectF& view, bool hovered);
/// Marks the probed point and tells its value.
void paintProbe(QPainter& painter, const QPointF& point, const QString& text, const QRectF& view);
/// A small line of text with its bottom right, or bottom centre, at `corner`.
void paintNote(QPainter& painter, const QString& text, const QPointF& corner, Qt::Alignment alignment);

} // namespace limn
