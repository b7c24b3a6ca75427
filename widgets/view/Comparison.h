// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/presets/Preset.h"
#include "scene/view/CompareLayout.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// A look that is compared with the scene's own: what it was before, or another preset.
struct ComparedLook {
  Preset shown;                     ///< at the left; its light has a model
  std::array<std::string, 2> names; ///< of what is at the left and, the scene's own look, at the right
  bool operator==(const ComparedLook&) const = default;
};

using SideModels = std::array<ShadingModel, 2>;

/// What a view shows: a scene, and with which models. Sides are numbered as they are drawn, positions as they
/// stand, from left to right; they differ only while the sides are swapped.
struct Comparison {
  Scene scene;
  CompareLayout layout = CompareLayout::single;
  /// Of the two sides of a comparison; the single layout shows the scene's own.
  SideModels models{ShadingModel::classic, ShadingModel::enhanced};
  /// Compared instead of models: then the right side is the scene as it is.
  std::optional<ComparedLook> look;
  double wipe = 0.5; ///< where the border of the wipe lies, as a fraction of the width, 0..1
  bool isSwapped = false;
  std::optional<glm::dvec3> markMm; ///< a place that is marked in the pictures, world
  std::optional<glm::dvec3> halfMm; ///< where half of a ray's light is gathered, world; marked, too
  std::string preview;              ///< the preset that the scene is a preview of; empty: none
};

/// The scene as one side shows it.
Scene sceneOfSide(const Comparison& comparison, int side);

/// The side that shows the scene as it is; of two models the first.
inline int ownSide(const Comparison& comparison) {
  return comparison.look && comparison.layout != CompareLayout::single ? 1 : 0;
}

/// What the pictures show, side by side.
std::vector<Scene> scenesOfSides(const Comparison& comparison);

/// The side at a position, 0 left or 1 right: the other one while the pictures are exchanged.
inline int sideShownAt(const Comparison& comparison, int position) {
  return comparison.isSwapped ? 1 - position : position;
}

} // namespace limn
