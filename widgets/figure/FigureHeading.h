// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/figure/FigureLayout.h"

#include <QPointF>

#include <vector>

namespace limn {

/// Words above a panel's picture that stand on one line.
struct HeadingPart {
  enum class Kind { letter, name, details };
  Kind kind = Kind::name;
  QString text;
  double left = 0.0; ///< from the heading's left edge on, pixels of the figure
  int line = 0;      ///< 0: the first
  bool operator==(const HeadingPart&) const = default;
};

/// "a  Enhanced  SP 1–64 · O 0–3", as the figure's marks ask, in a width of so many pixels: nothing is cut,
/// what finds no room goes on below. `layout` tells the size of the text.
std::vector<HeadingPart> headingParts(const Figure& figure, std::size_t panel, const FigureLayout& layout,
                                      double width);

QFont headingFont(const FigureLayout& layout, HeadingPart::Kind kind);

/// The height of headings in cells of so many pixels' width: all have that of the one with the most lines.
double headingHeight(const Figure& figure, const FigureLayout& layout, double width);

/// How far below the upper edge of a heading the words of a line stand.
double headingBaseline(const FigureLayout& layout, int line);

} // namespace limn
