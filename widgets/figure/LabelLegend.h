// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/figure/FigureLayout.h"

#include <QColor>

#include <vector>

class QPainter;

namespace limn {

/// So many labels stand in a legend.
inline constexpr std::size_t mostLabelRows = 12;

/// The labels that a panel shows by curves of their own, of a slice those that it outlines, in the order of
/// their list, with those curves; behind `mostLabelRows` one row says how many more there are. None where its
/// picture classifies by one curve alone.
PanelLabels panelLabels(const FigurePanel& panel);

/// Those of all panels, as the figure's marks tell of them: where it does not name the labels, their curves
/// are not drawn.
FigureLabels figureLabels(const Figure& figure);

/// How rows stand beside and below each other in a width, pixels of a figure.
struct LabelColumns {
  int columns = 1;
  double columnWidth = 0.0;
  double rowHeight = 0.0;
  double height = 0.0; ///< of all rows
};

/// Without `rows` nothing has a height.
LabelColumns labelColumns(const std::vector<LabelRow>& rows, double width, double textPixels);

/// Paints the rows from the upper left of a place on, column by column, names that are too long cut.
void paintLabelRows(QPainter& painter, const QRectF& place, const std::vector<LabelRow>& rows,
                    const FigureLayout& layout, const QColor& text, const QColor& line);

} // namespace limn
