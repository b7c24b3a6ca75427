// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/OverlayParts.h"
#include "widgets/view/overlay/OverlaySource.h"

#include <optional>

namespace limn {

/// What a region hides, as a few words: "Body only: table hidden", "3 labels hidden or faded"; empty where it
/// hides nothing.
QString regionText(const Region& region);

/// Tells under the first label that a part of the volume is hidden; a click on it shows everything again.
/// Absent where nothing is hidden.
std::optional<Note> regionNoteOf(const OverlaySource& source);

/// Whether a point of the view, logical pixels, lies on that note; never where there is none.
bool isOnRegionNote(const OverlaySource& source, const QPointF& point);

} // namespace limn
