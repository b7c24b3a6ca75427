// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/ColourTable.h"
#include "io/looks/dicom/Items.h"

#include <string>
#include <vector>

// The window and the table behind it: the VOI of the input (PS3.3 C.11.2) and the Volume Render Display
// module (C.11.32).

namespace limn::dicom {

/// The range of a window as its decimal strings hold it: a little wider than asked for where 16 characters
/// are too few.
struct WrittenWindow {
  std::string centre, width;
  ValueRange range;
};

/// The window over a range of values, of whose decimal strings none has more than 16 characters.
WrittenWindow windowOver(const ValueRange& range);

/// Writes the window into an item of the input sequence.
void putWindow(DcmItem& input, const WrittenWindow& window);

/// Writes the display module: one stream of one component that reads input 1 of the set.
void putDisplay(DcmItem& object, const std::string& inputSet, const ColourTable& table);

/// Reads window and table; `input` is the item of the input sequence. What is read otherwise than meant is
/// said in `changes`. Throws Error (input).
ColourTable displayIn(DcmItem& object, DcmItem& input, const std::string& name,
                      std::vector<Message>& changes);

} // namespace limn::dicom
