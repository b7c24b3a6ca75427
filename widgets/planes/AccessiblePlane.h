// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class PlaneView;

/// From now on assistive technology takes every PlaneView for a slider: its value is the place of the slice
/// along the patient, mm, and setting it goes there. Does so once, however often it is called.
void makePlanesAccessible();

/// Tells assistive technology, where some listens, that another slice is shown.
void tellPlaneMoved(PlaneView& view);

} // namespace limn
