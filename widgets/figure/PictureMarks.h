// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/figure/FigureLayout.h"
#include "widgets/figure/FigureText.h"

#include <optional>
#include <vector>

class QPainter;

namespace limn {

/// A letter at an edge of a picture.
struct EdgeLetter {
  QString text;
  QRectF place;
};

/// A bar of a round length in the lower left corner of a picture, its length above it.
struct FigureScaleBar {
  QString text;
  QRectF textPlace;
  QRectF bar;
};

/// What stands on a picture of a figure, pixels of the figure.
struct PictureMarks {
  std::vector<EdgeLetter> letters;
  std::optional<FigureScaleBar> scale;
};

/// The marks on the picture of one panel, as the figure asks for them.
PictureMarks pictureMarks(const Figure& figure, const FigureLayout& layout, std::size_t panel);

/// All that the marks cover of the picture, their dark edges included: the promise that no pixel outside is
/// touched, for whoever compares pictures with those of a figure.
std::vector<QRectF> coveredBy(const PictureMarks& marks, const FigureLayout& layout);

/// White with a dark edge, so that they stand out from any picture.
void paintPictureMarks(QPainter& painter, const PictureMarks& marks, const FigureLayout& layout);

} // namespace limn
