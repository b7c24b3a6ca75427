// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "widgets/Gesture.h"

#include <QString>

namespace limn {

/// What an edit changed, where that is one thing with a number: "opacity at 400 HU 0.55 → 0.6"; otherwise
/// what its gesture is called. In the imperative or as a noun, as history and undo show it.
QString changeText(const Scene& before, const Scene& after, const Gesture& gesture);

} // namespace limn
