// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/Overlay.h"

#include <QImage>

namespace limn {

/// Which marks go with a picture into a file.
struct SavedMarks {
  bool names = true;        ///< of models, or of the looks that are compared, and what the pictures hide
  bool letters = true;      ///< of the patient's sides, or that they are unknown
  bool scale = true;        ///< the bar
  bool warning = true;      ///< that it is not for diagnosis
  bool measurements = true; ///< that are shown
  bool operator==(const SavedMarks&) const = default;

  bool any() const { return names || letters || scale || warning || measurements; }
};

/// No marks: the picture alone.
inline constexpr SavedMarks noMarks{false, false, false, false, false};

/// What of the overlay of a picture at rest goes with it into a file: nothing that belongs to the pointer, to
/// a tool or to the state of the work.
Overlay savedOverlay(const OverlaySource& source, const SavedMarks& marks);

/// The same over what a file of this size (pixels) shows, of whatever shape: as large as a view that is as
/// high as the one there is, or as wide where that is flatter. Pictures beside each other have half of it
/// each.
OverlaySource inFile(OverlaySource source, const QSize& size);

/// The marks of a view alone, on nothing, in a picture of this size (pixels), as large in it as in the view.
QImage savedMarksImage(const OverlaySource& source, const SavedMarks& marks, const QSize& size);

} // namespace limn
