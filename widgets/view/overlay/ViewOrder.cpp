// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/ViewOrder.h"

namespace limn {

Scene sceneOfSide(const Comparison& comparison, int side) {
  Scene scene = comparison.scene;
  if (comparison.layout == CompareLayout::single)
    return scene;
  if (comparison.look) {
    if (side == 0)
      return withPreset(scene, comparison.look->shown);
    scene.shading.model = comparison.look->ownModel.value_or(scene.shading.model);
    return scene;
  }
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

int sideAt(const ViewOrder& order, const QPointF& point) {
  return sideShownAt(order.comparison, positionAt(order.geometry, point));
}

PictureState stateTold(PictureState state, const ViewOrder& order) {
  state.engine = order.inUse.engine;
  state.engineReason = order.inUse.reason;
  state.driverHasFailed = order.inUse.driverHasFailed;
  if (!order.inUse.limitation.isEmpty())
    state.limitation = order.inUse.limitation;
  for (std::size_t side = 0; order.measured && state.resting && side < state.sides.size(); ++side) {
    Scene scene = sceneOfSide(order.comparison, static_cast<int>(side));
    scene.quality = qualityShown(scene.quality, state.sides[side]);
    state.sides[side].measuredLevels = (*order.measured)(scene);
  }
  return state;
}

} // namespace limn
