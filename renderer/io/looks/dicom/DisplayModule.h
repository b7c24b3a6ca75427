// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/dicom/ColourTable.h"
#include "io/looks/dicom/Items.h"
#include "scene/light/Shading.h"
#include "scene/view/Camera.h"

#include <string>
#include <vector>

// The window and the table behind it: the VOI of the input (PS3.3 C.11.2) and the Volume Render Display
// module (C.11.32).

// The Render Shading module (PS3.3 C.11.31): Phong with coefficients alone, white highlights, one white light
// at infinity. A look without it is unlit.
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

/// The exponent of the smoothest surface, shininess 1.
inline constexpr double largestExponent = 1024.0;

/// The nearest light that the module can hold; nothing is written for an unlit scene.
void putShading(DcmItem& object, const Shading& shading, const Camera& camera);

/// Unlit where the module is absent. Throws Error (input).
Shading shadingIn(DcmItem& object, const std::string& name, std::vector<Message>& changes);

} // namespace limn::dicom
