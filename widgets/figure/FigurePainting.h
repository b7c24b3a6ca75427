// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/view/FigureSettings.h"
#include "widgets/figure/FigureLayout.h"
#include "widgets/figure/FigureText.h"

#include <QColor>
#include <QFont>
#include <QImage>
#include <QRectF>

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

/// The values over which the curve of a panel is shown: one axis for all curves of values in one unit, so
/// that they can be compared by eye, with some room beside their outermost points.
ValueRange legendRange(const Figure& figure, const FigureLayout& layout, std::size_t panel);

/// The marks on the picture of one panel, as the figure asks for them.
PictureMarks pictureMarks(const Figure& figure, const FigureLayout& layout, std::size_t panel);

/// All that the marks cover of the picture, their dark edges included: the promise that no pixel outside is
/// touched, for whoever compares pictures with those of a figure.
std::vector<QRectF> coveredBy(const PictureMarks& marks, const FigureLayout& layout);

/// Paints the page outside the pictures. Together with the pictures it fills the figure.
void paintPage(QPainter& painter, const Figure& figure, const FigureLayout& layout);

/// Paints everything but page and pictures, all text as text; in pixels of the layout.
void paintMarks(QPainter& painter, const Figure& figure, const FigureLayout& layout);

/// Paints a whole figure. `pictures` are those of its panels, each of the layout's size; one that is null is
/// still to come and leaves its place grey. No pixel of a picture is changed outside the marks on it.
void paintFigure(QPainter& painter, const Figure& figure, const FigureLayout& layout,
                 const std::vector<QImage>& pictures);

/// The figure as a picture: opaque, or with an alpha channel where its page is transparent. Throws
/// std::bad_alloc where there is no memory for it.
QImage figureImage(const Figure& figure, const FigureLayout& layout, const std::vector<QImage>& pictures);

} // namespace limn
