// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/view/FigureSettings.h"
#include "scene/view/Measurement.h"
#include "scene/view/PlaneSettings.h"

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QSize>
#include <QString>

#include <optional>
#include <vector>

namespace limn {

/// Of a picture of physical light, how many paths each pixel has, and their standard error, levels RMS;
/// absent where there are too few to tell.
struct PanelPaths {
  int paths = 0;
  std::optional<double> rmsLevels;
  bool isFiltered = false;
  bool operator==(const PanelPaths&) const = default;
};

/// One picture of a figure: a scene, or a slice of its volume.
struct FigurePanel {
  QString name;
  Scene scene;                       ///< with a volume
  std::optional<PatientPlane> plane; ///< absent: the picture of the scene
  PlaneSettings planes;              ///< what a slice shows
  GreyWindow firstWindow;            ///< of a slice whose settings have none
  /// Of the volume, in the order of their list.
  std::vector<Measurement> measurements = {};
  /// How far the picture is from the exact one, levels (99.9th percentile), as far as that is known.
  std::optional<double> errorLevels;
  std::optional<PanelPaths> paths{}; ///< of physical light, which tells its error itself
  /// Whether the crop takes nothing away that would be seen, so that no note tells of it; where known.
  std::optional<bool> cropHidesNothing{};
  bool isAim = false;    ///< it is what the drawing goes for; what it reached is known afterwards
  bool isStated = false; ///< pixels drawn at random and integrated exactly say so; otherwise it is estimated
  bool operator==(const FigurePanel&) const = default;
};

/// Everything that a figure shows.
struct Figure {
  FigureSettings settings;
  std::vector<FigurePanel> panels; ///< 1..mostPanels, row by row
  bool operator==(const Figure&) const = default;
};

/// A label in a legend. The row that says how many more there are has no colour.
struct LabelRow {
  std::optional<QColor> color;
  QString text;
  bool operator==(const LabelRow&) const = default;
};

/// The curve of a label in a legend.
struct LabelCurve {
  QColor color; ///< of its row
  TransferFunction function;
  bool operator==(const LabelCurve&) const = default;
};

/// What is told of the labels of a panel (LabelLegend). Looking at its voxels takes time: it is found once.
struct PanelLabels {
  std::vector<LabelRow> rows;
  std::vector<LabelCurve> curves; ///< of their own, of those that have a row, in the same order
  std::size_t undrawn = 0;        ///< so many more of them are drawn nowhere
  bool operator==(const PanelLabels&) const = default;
};
using FigureLabels = std::vector<PanelLabels>; ///< of each panel

/// Where a curve stands that explains colours, or a list of labels.
struct LegendPlace {
  QRectF place;
  std::size_t panel = 0; ///< whose it is
};

/// Where everything of a figure stands, in pixels of the figure. Pictures lie on whole pixels and all have
/// one size.
struct FigureLayout {
  QSize size;
  double textPixels = 0.0; ///< the height of the body's font
  std::vector<QRect> pictures;
  std::vector<QRectF> headings; ///< above the pictures; empty where there are none
  /// One below all pictures where they share a curve, otherwise one below each that has one.
  std::vector<LegendPlace> legends;
  /// The same of the labels that have curves of their own.
  std::vector<LegendPlace> labelLegends;
  QRectF notes;        ///< empty where nothing is said
  FigureLabels labels; ///< that it was laid out for

  QSize pictureSize() const { return pictures.front().size(); }
};

/// Lays a figure out: one to three panels in a row, four in two rows. Throws Error (usage) where it is
/// smaller or larger than a figure can be, or its marks leave no room for pictures.
FigureLayout figureLayout(const Figure& figure);
/// The same where its labels are known (figureLabels).
FigureLayout figureLayout(const Figure& figure, FigureLabels labels);

/// The font of a figure's text, `scale` times as large as the body's: the same in pixels and in vectors.
QFont figureFont(const FigureLayout& layout, double scale = 1.0);

/// The size of the notes below, as a share of the body's.
inline constexpr double noteScale = 0.85;

} // namespace limn
