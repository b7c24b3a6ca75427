// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class PlaneView;

/// From now on assistive technology finds slices as sliders: their value is the place of the slice along the
/// patient, mm, and setting it goes there. Cheap to call again.
void makePlanesAccessible();

/// Tells it that another slice is shown.
void tellPlaneMoved(PlaneView& view);

} // namespace limn
