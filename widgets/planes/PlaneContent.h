// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/view/Measurement.h"

#include <QString>

namespace limn {

/// Labels that stand out in slices, whatever is kept and tinted: a piece before it is cut.
struct PlaneLit {
  std::shared_ptr<const LabelMap> map; ///< on the volume's grid; null: nothing stands out
  std::vector<bool> isLit;             ///< of each label of the map
  bool operator==(const PlaneLit&) const = default;
};

/// Everything that slices show.
struct PlaneContent {
  std::shared_ptr<const Volume> volume; ///< null: nothing is open
  TransferFunction function;
  Region keep;
  CropBox crop;
  PlaneSettings settings;
  GreyWindow firstWindow;                                    ///< where the settings have none
  std::optional<std::size_t> emphasisedPoint = std::nullopt; ///< of the function: what it governs lights up
  /// Whose own curve it is of, by the place in the list of labels; none: of the function.
  std::optional<std::size_t> emphasisedLabel = std::nullopt;
  std::vector<Measured> measured = {};              ///< in the volume
  std::optional<std::size_t> inHand = std::nullopt; ///< of these, which is highlighted
  PlaneLit lit = {};
  bool operator==(const PlaneContent&) const = default;
};

/// The place of the crosshair, world millimetres; there is a volume.
glm::dvec3 crosshairOf(const PlaneContent& content);

/// What a slice shows before anyone zooms: all of the volume, or where the body alone is kept the box around
/// that, because a table beside it would take half of the view. There is a volume.
Grid seenGrid(const PlaneContent& content);

/// The grey window that is shown.
GreyWindow windowOf(const PlaneContent& content);

/// The value under the crosshair, trilinear as probe and picture have it; nothing outside the volume or where
/// there is none.
std::optional<double> valueUnderCrosshair(const PlaneContent& content);

/// The settings with the crosshair at a place; where that lies beyond the centres of the volume's outermost
/// slices it goes to those.
PlaneSettings withCrosshair(const PlaneContent& content, const glm::dvec3& worldMm);

/// The crosshair moved by so many slices along one of the patient's directions (axesOf).
PlaneSettings withCrosshairMoved(const PlaneContent& content, const glm::dvec3& direction, int slices);

/// The settings with one plane large, or where that is so already with all three.
PlaneSettings withLargeToggled(PlaneSettings settings, PatientPlane plane);

/// "Axial"; where the file says nothing of sides, what is stacked in the plane: "Columns × rows".
QString planeTitle(const Volume& volume, PatientPlane plane);

/// Where the slice lies: "12.3 mm S · 45/108". The number of slices stands only where the grid's axes are the
/// patient's, the letter only where sides are known.
QString slicePlaceText(const PlaneContent& content, PatientPlane plane);

/// The value under the crosshair, "38 HU", and what a segmentation says of it, "38 HU · Liver · opacity 0.2";
/// empty where it lies outside.
QString crosshairText(const PlaneContent& content);

/// "W 400 · L 40"; of a slab "max 20 mm · W 400 · L 40".
QString windowText(const PlaneContent& content);

/// The decimals that values of a volume are worth showing with.
int valueDecimals(const Volume& volume);

} // namespace limn
