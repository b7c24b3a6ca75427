// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/scenes/HeadScene.h"

namespace limn {

TransferFunction skinMuscleBone() {
  return {1.0,
          {{-500, {0.90, 0.70, 0.55}, 0.0},
           {-250, {0.90, 0.70, 0.55}, 0.02},
           {-30, {0.85, 0.55, 0.40}, 0.03},
           {40, {0.75, 0.25, 0.20}, 0.12},
           {120, {0.75, 0.25, 0.20}, 0.10},
           {250, {0.95, 0.90, 0.80}, 0.30},
           {1200, {1.00, 1.00, 0.95}, 0.80}}};
}

Scene headScene(std::shared_ptr<const Volume> volume, ShadingModel model) {
  Scene scene;
  scene.camera = defaultCamera(volume->grid());
  scene.volume = std::move(volume);
  scene.transferFunction = skinMuscleBone();
  scene.shading.model = model;
  scene.quality.stepVoxels = 0.25;
  scene.quality.earlyTermination = 1.0;
  return scene;
}

} // namespace limn
