// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/Comparison.h"

namespace limn {

Scene sceneOfSide(const Comparison& comparison, int side) {
  Scene scene = comparison.scene;
  if (comparison.layout == CompareLayout::single)
    return scene;
  if (comparison.look)
    return side == 0 ? withPreset(scene, comparison.look->shown) : scene;
  scene.shading.model = comparison.models[static_cast<std::size_t>(side)];
  return scene;
}

std::vector<Scene> scenesOfSides(const Comparison& comparison) {
  std::vector<Scene> scenes;
  scenes.reserve(2);
  for (int side = 0; side < pictureCount(comparison.layout); ++side)
    scenes.push_back(sceneOfSide(comparison, side));
  return scenes;
}

} // namespace limn
