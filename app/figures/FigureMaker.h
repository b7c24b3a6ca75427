// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/drawing/PictureMaker.h"
#include "app/core/sources/SceneSource.h"
#include "widgets/figure/FigureLayout.h"

#include <QImage>

#include <functional>
#include <string>

namespace limn {

/// A panel of a figure that was loaded; its scene still lacks what a first look has (`loaded.hasOwnCamera`).
FigurePanel panelOf(const LoadedFigure::Panel& loaded);

/// A slice of a scene's volume through the middle of it, or as `planes` say.
FigurePanel planePanel(const Scene& scene, PatientPlane plane, const PlaneSettings& planes);

/// A figure whose pictures are drawn.
struct MadeFigure {
  Figure figure; ///< its scenes as they were drawn, with the steps that keep their tolerances
  FigureLayout layout;
  std::vector<QImage> pictures; ///< by panel; over the scene's background, or without where the page has none
  std::vector<Image> floats;    ///< by panel, where they were asked for: premultiplied, without background
  std::string engine;           ///< who drew, for people; empty where only slices are shown
  std::vector<std::string> notes; ///< one sentence each
  /// By panel, as the file keeps it: what chance or paths said. What else is known of an error is the
  /// estimate that its panel has.
  std::vector<std::optional<PictureAccuracy>> stated{};
};

/// How a file that may travel calls a volume or label map at a path; the volume that is shown decides what
/// may be said.
using NameInFile = std::function<std::string(const std::string& path, const Volume& volume)>;

/// What is written into a figure's file so that it can be opened again; `volumePaths` by panel.
std::string figureDescription(const MadeFigure& made, const std::vector<std::string>& volumePaths,
                              const NameInFile& named);

/// What is made of a figure's pictures.
enum class FigurePixels {
  bytes, ///< as most files have them
  floats ///< beside them, for EXR
};

/// Draws the pictures of a figure's panels in so many pixels each, with one renderer; leaves the layout open.
/// Tells and asks `order.effort`. Throws Error and Cancelled.
MadeFigure drawPanels(const Figure& figure, const QSize& size, const MakingOptions& order,
                      FigurePixels pixels = FigurePixels::bytes);

/// Draws every picture of a figure in the size that its layout gives them, with one renderer, as `limn
/// render` does: the same bits. Where it tells errors, pixels drawn at random say them
/// (accuracy/sweep/ErrorByChance); where those do not settle they are estimated. Tells and asks
/// `order.effort`. Throws Error and Cancelled.
MadeFigure makeFigure(const Figure& figure, const MakingOptions& order,
                      FigurePixels pixels = FigurePixels::bytes);

/// The figure with those errors estimated that it tells and that are not known: from small pictures of the
/// same views with their steps halved twice (accuracy/ErrorEstimate). Throws Error and Cancelled.
Figure withErrors(Figure figure, const MakingOptions& order);

/// The most bytes that a figure takes while it is made and written.
double bytesToMake(const FigureLayout& layout, FigurePixels pixels);

/// "The figure is 20,000 × 20,000 pixels and takes 8.0 GB of memory while it is made; 3.1 GB are free." Empty
/// where there is plenty.
std::string memoryNote(const FigureLayout& layout, FigurePixels pixels);

/// Whether the computer has that much memory. True where it does not tell.
bool hasMemoryFor(const FigureLayout& layout, FigurePixels pixels);

} // namespace limn
