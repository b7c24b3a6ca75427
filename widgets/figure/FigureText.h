// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/figure/FigureLayout.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDrag.h"
#include "widgets/view/overlay/OrientationMarks.h"

#include <QSize>

namespace limn {

/// "a" for the first panel, "b" for the second.
QString panelLetter(std::size_t index);

/// What a panel is called where nobody names it: its model or projection, or its plane.
QString usualName(const FigurePanel& panel);

/// How a picture is lit, after its model or projection where its name tells neither, or where a slice lies
/// and in which grey: "Enhanced · SP 1–64 · O 0–3".
QString panelDetails(const FigurePanel& panel);

/// What slices show of a panel's volume; only of one that shows a plane.
PlaneContent planeContentOf(const FigurePanel& panel);

/// The plane of such a panel in a picture of so many pixels: the whole volume.
PlaneFrame planeFrameOf(const FigurePanel& panel, const QSize& pixels);

/// Millimetres per pixel of a panel's picture; in perspective at the depth of what is seen in its middle, or
/// of the camera's target where that is not known.
double mmPerPixelOf(const FigurePanel& panel, const QSize& pixels);

/// The directions at the edges of a panel's picture; none where the file says nothing of sides.
std::optional<OrientationLetters> lettersOfPanel(const FigurePanel& panel);

/// Whether a curve explains the colours of a panel: not those of a slice in plain grey.
bool hasCurve(const FigurePanel& panel);

/// What is said below the pictures, as the figure's marks ask: accuracy, whose curves are drawn, hidden
/// parts, at which depth scale bars hold, and that it is not for diagnosis. Empty where nothing is.
QString notesOf(const Figure& figure);
/// The same where its labels are known (figureLabels).
QString notesOf(const Figure& figure, const FigureLabels& labels);

} // namespace limn
