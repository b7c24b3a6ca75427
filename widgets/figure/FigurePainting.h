// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/figure/FigureLayout.h"

#include <QImage>

#include <vector>

class QPainter;

namespace limn {

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
