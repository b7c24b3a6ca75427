// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/figure/Figure.h"

#include <QFont>
#include <QRectF>
#include <QSize>

namespace limn {

/// Where a curve stands that explains colours.
struct LegendPlace {
  QRectF place;
  std::size_t panel = 0; ///< whose curve it is
};

/// Where everything of a figure stands, in pixels of the figure. Pictures lie on whole pixels and all have
/// one size.
struct FigureLayout {
  QSize size;
  double textPixels = 0.0; ///< the height of the body's font
  std::vector<QRect> pictures;
  std::vector<QRectF> headings; ///< above the pictures; empty where there are none
  /// One below all pictures where they share a curve, otherwise one below each that has one.
  std::vector<LegendPlace> legends;
  QRectF notes; ///< empty where nothing is said

  QSize pictureSize() const { return pictures.front().size(); }
};

/// Lays a figure out: one to three panels in a row, four in two rows. Throws Error (usage) where it is
/// smaller or larger than a figure can be, or its marks leave no room for pictures.
FigureLayout figureLayout(const Figure& figure);

/// The font of a figure's text, `scale` times as large as the body's: the same in pixels and in vectors.
QFont figureFont(const FigureLayout& layout, double scale = 1.0);

/// The size of the notes below, as a share of the body's.
inline constexpr double noteScale = 0.85;

} // namespace limn
