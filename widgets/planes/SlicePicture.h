// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDrag.h"
#include "widgets/view/overlay/SavedOverlay.h"

#include <QFont>
#include <QImage>
#include <QSizeF>

namespace limn {

/// A slice as it is seen in a view, of which a picture is to be kept; there is a volume.
struct SeenSlice {
  PlaneContent content;
  PatientPlane plane = PatientPlane::axial;
  PlaneFrame frame; ///< its pixels are those of the picture
  QSizeF size;      ///< of the view, logical pixels
  QFont font;
};

/// The picture of a slice with these marks, as large on it as in the view: its title and window are names.
/// Neither the crosshair nor what is in hand goes with it. Throws Error (other) where there is no memory for
/// so many pixels. For any thread.
QImage slicePicture(const SeenSlice& slice, const SavedMarks& marks);

} // namespace limn
