// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "widgets/figure/FigureLayout.h"

#include <QColor>
#include <QString>

#include <optional>
#include <vector>

class QPainter;

namespace limn {

/// A label in a legend. The row that says how many more there are has no colour.
struct LabelRow {
  std::optional<QColor> color;
  QString text;
  bool operator==(const LabelRow&) const = default;
};

/// So many labels stand in a legend.
inline constexpr std::size_t mostLabelRows = 12;

/// The labels that a panel shows by curves of their own, of a slice those that it outlines, in the order of
/// their list; behind `mostLabelRows`
/// one row says how many more there are. None where its picture classifies by one curve alone.
std::vector<LabelRow> labelRows(const FigurePanel& panel);

/// The curve of a label in a legend.
struct LabelCurve {
  QColor color; ///< of its row
  TransferFunction function;
  bool operator==(const LabelCurve&) const = default;
};

/// The curves of their own by which a panel shows labels, of those that have a row, in the same order.
std::vector<LabelCurve> labelCurves(const FigurePanel& panel);

/// Those that are drawn beside the curve of the panel's scene: where the figure names the labels.
std::vector<LabelCurve> drawnLabelCurves(const Figure& figure, std::size_t panel);

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
