// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"

namespace limn {

/// From where a freshly opened volume is seen: as by defaultCamera, but a single slice face-on, as
/// radiologists look at it (axial from the feet, coronal from the front, sagittal from the left) and upright.
/// Keeps projection and field of view of `camera`.
Camera firstView(const Camera& camera, const Grid& grid);

} // namespace limn
