// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/view/CompareLayout.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// What a view shows: a scene, and with which models. Sides are numbered as they are drawn, positions as they
/// stand, from left to right; they differ only while the sides are swapped.
struct Comparison {
  Scene scene;
  CompareLayout layout = CompareLayout::single;
  /// Of the two sides of a comparison; the single layout shows the scene's own.
  std::array<ShadingModel, 2> models{ShadingModel::classic, ShadingModel::enhanced};
  double wipe = 0.5; ///< where the border of the wipe lies, as a fraction of the width, 0..1
  bool isSwapped = false;
  std::optional<glm::dvec3> markMm; ///< a place that is marked in the pictures, world
  std::string preview;              ///< the preset that the scene is a preview of; empty: none
};

/// The scene as one side shows it.
Scene sceneOfSide(const Comparison& comparison, int side);

/// What the pictures show, side by side.
std::vector<Scene> scenesOfSides(const Comparison& comparison);

inline int sideShownAt(const Comparison& comparison, int position) {
  return comparison.isSwapped ? 1 - position : position;
}

} // namespace limn
