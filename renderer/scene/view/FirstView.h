// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

namespace limn {

/// From where a freshly opened volume is seen: as by defaultCamera, but a single slice face-on, as
/// radiologists look at it (axial from the feet, coronal from the front, sagittal from the left) and upright.
/// Where no file or person told the orientation, a stack less than a third as thick as it is wide and high is
/// seen so, too: nobody knows which side of it is the front. Keeps projection and field of view of `camera`.
Camera firstView(const Camera& camera, const Grid& grid, bool orientationKnown);

} // namespace limn
