// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SceneFile.h"
#include "scene/view/FigureSettings.h"
#include "scene/view/PlaneSettings.h"

#include <optional>
#include <vector>

namespace limn {

/// A picture of a figure as read.
struct FigurePanelDocument {
  std::string name;                  ///< what stands above it
  std::optional<PatientPlane> plane; ///< a slice of the scene's volume; absent: the picture of the scene
  PlaneSettings planes;              ///< what a slice shows
  SceneDocument scene;               ///< as read; `scene.scene.volume` is empty
  std::optional<PictureAccuracy> accuracy{}; ///< of the picture as it was drawn, where that was stated
  bool operator==(const FigurePanelDocument&) const = default;
};

/// What a figure shows, as it is written into its file.
struct FigureDocument {
  FigureSettings settings;
  std::vector<FigurePanelDocument> panels; ///< 1..mostPanels, row by row
  bool operator==(const FigureDocument&) const = default;
};

/// Whether a text is the JSON of a figure. Never throws.
bool looksLikeFigure(std::string_view text);

/// Reads the text of a figure, as strictly as parseScene. `name` is how errors call it. Throws Error (input).
FigureDocument parseFigure(std::string_view text, const std::string& name);

/// A figure as JSON, ASCII; paths are stored as given.
std::string figureToJson(const FigureDocument& figure);

/// The same of its settings alone.
FigureSettings parseFigureSettings(std::string_view text, const std::string& name);
std::string figureSettingsToJson(const FigureSettings& settings);

} // namespace limn
