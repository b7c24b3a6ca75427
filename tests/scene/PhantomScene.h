// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/volume/Phantom.h"

namespace limn::test {

/// The phantom in voxels of 12 mm, seen through a ramp: a scene to plan with, not to look at.
inline Scene roughPhantomScene() {
  Scene scene;
  scene.volume = phantomVolume({12.0, 0.0, 1});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.transferFunction.points = {{-300, {0.9, 0.6, 0.5}, 0.0}, {1500, {1.0, 1.0, 1.0}, 0.9}};
  return scene;
}

} // namespace limn::test
