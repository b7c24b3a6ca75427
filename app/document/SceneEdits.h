// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/volume/Histogram.h"

namespace limn {

/// The scene with another projection. A surface at a value that the volume does not have, or one in
/// Hounsfield units in other data, begins between background and object; `histogram` is the volume's.
Scene withProjection(Scene scene, Projection projection, const Histogram& histogram);

/// The camera with parallel rays or with a vanishing point; the target plane keeps its size on screen.
Camera withProjection(Camera camera, Camera::Projection projection);

} // namespace limn
