// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/figure/FigureLayout.h"
#include "widgets/view/overlay/MeasureMarks.h"

#include <QFont>
#include <QRectF>

#include <vector>

class QPainter;

namespace limn {

/// What was measured as it stands on the picture of a panel. It is laid out as over a picture on screen whose
/// text is as high as `font`, and made larger by `scale` with the figure's own text.
struct FigureMeasures {
  QRectF picture;     ///< pixels of the figure
  double scale = 1.0; ///< pixels of the figure for one of the layout of `marks`, > 0
  QFont font;
  std::vector<MeasureMark> marks; ///< from the picture's upper left corner on
};

/// The measurements of a panel that are seen in its picture: of a slice those that lie in it, of a scene all
/// that the window shows there. Texts keep clear of `plates`, pixels of the figure.
FigureMeasures figureMeasures(const FigurePanel& panel, const FigureLayout& layout, const QRectF& picture,
                              const std::vector<QRectF>& plates);

/// All that they cover, pixels of the figure.
std::vector<QRectF> coveredBy(const FigureMeasures& measures);

/// Paints them in pixels of the figure, nothing beside the picture.
void paintFigureMeasures(QPainter& painter, const FigureMeasures& measures);

} // namespace limn
