// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/sources/SceneSource.h"
#include "app/files/figure/PanelList.h"
#include "scene/presets/Preset.h"
#include "scene/view/NamedView.h"
#include "scene/volume/Histogram.h"
#include "widgets/view/overlay/ViewOrder.h"

#include <optional>
#include <vector>

namespace limn {

/// From which pictures of a figure are made.
struct FigureIngredients {
  Scene scene;                      ///< with a volume
  std::vector<Scene> sides;         ///< what is on screen, from left to right
  std::optional<ComparedLook> look; ///< that is compared on screen with the scene's own
  std::optional<Preset> remembered; ///< the look remembered as "before"
  PlaneSettings planes;
  std::vector<Measurement> measurements;
  GreyWindow firstWindow; ///< of slices whose settings have none
  std::vector<Preset> presets;
  std::vector<NamedView> views;
  Histogram histogram;             ///< of the volume
  std::vector<std::string> fitted; ///< names of those presets that were moved onto its values
};

/// All that can stand in a panel: two looks that are compared, the scene with every model, as it was before,
/// from the views that were kept and from every side, its slices, every preset from where the camera is.
std::vector<PanelSource> panelSources(const FigureIngredients& from);

/// What a figure begins with, places in `panelSources`: what is on screen, slices beside one picture too.
std::vector<std::size_t> firstPanels(const std::vector<PanelSource>& sources, const FigureIngredients& from);

/// The panels of a figure that was saved, under their names there.
std::vector<PanelSource> sourcesOf(const LoadedFigure& figure);

} // namespace limn
