// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/OverlayParts.h"
#include "widgets/view/overlay/OverlaySource.h"

#include <optional>

namespace limn {

/// What a region hides, as a few words: "Body only: table hidden", "3 labels hidden or faded"; empty where it
/// hides nothing.
QString regionText(const Region& region);

/// The same with what the crop box cuts off: "Body only: table hidden · cropped"; empty where all is shown.
QString hiddenText(const Scene& scene);

/// Tells under the label of the picture that stands at `position` that a part of the volume is hidden; a
/// click on it shows everything again. It is as wide under the pointer as without it. Absent where nothing is
/// hidden.
std::optional<Note> regionNoteOf(const OverlaySource& source, int position = 0);

/// The position of the picture on whose note a point of the view, logical pixels, lies; -1 for none.
int regionNoteAt(const OverlaySource& source, const QPointF& point);

} // namespace limn
