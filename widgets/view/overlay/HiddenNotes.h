// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/OverlayParts.h"
#include "widgets/view/overlay/OverlaySource.h"

namespace limn {

/// What a region hides: "Body only: table hidden", "2 labels hidden or faded"; empty where it hides nothing.
QString regionText(const Region& region);

/// Tells that a part of the volume is hidden, and by what.
struct HiddenNote {
  HiddenBy by;
  Note note;
};

/// Those under the label of the picture that stands at `position`, one below the other; a click on one takes
/// back what it tells. They are as wide under the pointer as without it.
std::vector<HiddenNote> hiddenNotesOf(const OverlaySource& source, int position = 0);

/// The one on which a point of the view, logical pixels, lies.
std::optional<HiddenPlace> hiddenNoteAt(const OverlaySource& source, const QPointF& point);

} // namespace limn
