// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/Comparison.h"
#include "widgets/view/ViewGeometry.h"
#include "widgets/view/pictures/PictureLoop.h"

namespace limn {

/// The pictures that a comparison in a view needs.
PictureRequest requestOf(const Comparison& comparison, const ViewGeometry& geometry);

/// How they are put together on the screen.
Pictures::Arrangement arrangementOf(const Comparison& comparison, const ViewGeometry& geometry);

} // namespace limn
