// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/figure/PanelList.h"
#include "scene/presets/Preset.h"
#include "scene/volume/Histogram.h"

#include <vector>

namespace limn {

/// From which pictures of a figure are made.
struct FigureIngredients {
  Scene scene;              ///< with a volume
  std::vector<Scene> sides; ///< what is on screen, from left to right
  PlaneSettings planes;
  GreyWindow firstWindow; ///< of slices whose settings have none
  std::vector<Preset> presets;
  Histogram histogram; ///< of the volume
};

/// All that can stand in a panel: the scene with every model, its slices, every preset from where the camera
/// is.
std::vector<PanelSource> panelSources(const FigureIngredients& from);

/// What a figure begins with, places in `panelSources`: what is on screen, slices beside one picture too.
std::vector<std::size_t> firstPanels(const std::vector<PanelSource>& sources, const FigureIngredients& from);

} // namespace limn
