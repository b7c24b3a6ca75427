// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/view/FigureSettings.h"
#include "scene/view/PlaneSettings.h"

#include <QString>

#include <optional>
#include <vector>

namespace limn {

/// One picture of a figure: a scene, or a slice of its volume.
struct FigurePanel {
  QString name;
  Scene scene;                       ///< with a volume
  std::optional<PatientPlane> plane; ///< absent: the picture of the scene
  PlaneSettings planes;              ///< what a slice shows
  GreyWindow firstWindow;            ///< of a slice whose settings have none
  /// How far the picture is from the exact one, levels (99.9th percentile), as far as it was estimated.
  std::optional<double> errorLevels;
  bool operator==(const FigurePanel&) const = default;
};

/// Everything that a figure shows.
struct Figure {
  FigureSettings settings;
  std::vector<FigurePanel> panels; ///< 1..mostPanels, row by row
  bool operator==(const Figure&) const = default;
};

} // namespace limn
