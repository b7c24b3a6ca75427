// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

class TrackSlider;

/// Makes assistive technology find in every TrackSlider what Qt's sliders are: role, name and value. Of two
/// handles it finds a group with a slider each, which ends where the other handle is.
void makeTracksAccessible();

/// Says to assistive technology that a number changed.
void tellValue(TrackSlider& slider, int handle);

/// Says which of two handles has the focus, where one has it.
void tellFocus(TrackSlider& slider);

} // namespace limn
