// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/sources/SceneSource.h"
#include "widgets/figure/FigureLayout.h"

#include <functional>
#include <string>

namespace limn {

/// A panel of a figure that was loaded; its scene still lacks what a first look has (`loaded.hasOwnCamera`).
FigurePanel panelOf(const LoadedFigure::Panel& loaded);

/// A slice of a scene's volume through the middle of it, or as `planes` say.
FigurePanel planePanel(const Scene& scene, PatientPlane plane, const PlaneSettings& planes);

/// How a file that may travel calls a volume or label map at a path; the volume that is shown decides what
/// may be said.
using NameInFile = std::function<std::string(const std::string& path, const Volume& volume)>;

/// What is written into a figure's file so that it can be opened again; `volumePaths` by panel.
std::string figureDescription(const Figure& figure, const std::vector<std::string>& volumePaths,
                              const NameInFile& named);

} // namespace limn
