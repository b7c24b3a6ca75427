// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/presets/Preset.h"
#include "scene/view/Measurement.h"
#include "widgets/properties/CropFaces.h"
#include "widgets/view/overlay/CutLine.h"
#include "widgets/view/overlay/ViewGeometry.h"
#include "widgets/view/pictures/InteractionQuality.h"
#include "widgets/view/pictures/PictureState.h"

#include <QFont>
#include <QString>

#include <array>
#include <functional>
#include <memory>
#include <string>

namespace limn {

/// A look that is compared with the scene's own: what it was before, or another preset.
struct ComparedLook {
  Preset shown;                           ///< at the left; its light has a model
  std::array<std::string, 2> names;       ///< of what is at the left and, the scene's own look, at the right
  std::optional<ShadingModel> ownModel{}; ///< of the scene's own look, where it is not shown by the scene's
  bool operator==(const ComparedLook&) const = default;
};

using SideModels = std::array<ShadingModel, 2>;

/// Something measured, as pictures show it.
struct SeenMeasure {
  std::size_t number = 0; ///< in the list of measurements
  Measurement::Kind kind = Measurement::Kind::distance;
  std::vector<glm::dvec3> placesMm; ///< world; the last are absent while it is being measured
  QString text;
  bool isInHand = false;
  bool isOpen = false; ///< nothing of it can be taken here: it is being measured, or lies in a slice
  /// All of its places lie behind what is seen, in the picture of each side.
  std::array<bool, 2> isHidden{};
  bool operator==(const SeenMeasure&) const = default;
};

/// A scene in one picture or two. Sides are numbered as they are drawn, positions as they stand, from left to
/// right; they differ only while the sides are swapped.
struct Comparison {
  Scene scene;
  CompareLayout layout = CompareLayout::single;
  /// Of the two sides of a comparison; the single layout shows the scene's own.
  SideModels models{ShadingModel::classic, ShadingModel::enhanced};
  /// Compared instead of models: then the right side is the scene as it is.
  std::optional<ComparedLook> look;
  double wipe = 0.5; ///< where the border of the wipe lies, as a fraction of the width, 0..1
  bool isSwapped = false;
  std::optional<glm::dvec3> markMm;       ///< a place that is marked in the pictures, world
  std::array<bool, 2> markIsHidden{};     ///< by what is seen before it, in the picture of each side
  std::optional<glm::dvec3> halfMm;       ///< where half of a ray's light is gathered, world; marked, too
  std::optional<glm::dvec3> turnsAboutMm; ///< about which turns go, world; absent: the camera's target
  std::vector<SeenMeasure> measures;      ///< drawn over the pictures
  std::optional<TurnedBox> turnedBox;     ///< in the place of the crop's, as long as there is one
  bool cropHidesNothing = false;          ///< that would be seen: then no note tells of the crop
  std::string preview;                    ///< the preset that the scene is a preview of; empty: none
  bool operator==(const Comparison&) const = default;
};

/// The scene as one side shows it.
Scene sceneOfSide(const Comparison& comparison, int side);

/// What the pictures show, side by side.
std::vector<Scene> scenesOfSides(const Comparison& comparison);

/// The side that shows the scene as it is; of two models the first.
inline int ownSide(const Comparison& comparison) {
  return comparison.look && comparison.layout != CompareLayout::single ? 1 : 0;
}

/// The side at a position, 0 left or 1 right: the other one while the pictures are exchanged.
inline int sideShownAt(const Comparison& comparison, int position) {
  return comparison.isSwapped ? 1 - position : position;
}

/// What may hide a part of the volume.
enum class HiddenBy { region, crop };

/// A note that tells what is hidden.
struct HiddenPlace {
  int position; ///< of its picture
  HiddenBy by;
  bool operator==(const HiddenPlace&) const = default;
};

/// What of the overlay the pointer is over, or holds.
struct Hovered {
  int label = -1; ///< the position of a picture, -1 for none
  bool wipe = false;
  std::optional<HiddenPlace> hidden;
  std::optional<CropFace> face;
  std::optional<std::size_t> cubeFace{}; ///< of the cube that shows how the picture lies (cubeFaces)
  bool measure = false;                  ///< a handle of a measurement
  bool operator==(const Hovered&) const = default;
};

/// A value read under the pointer.
struct ReadValue {
  double value = 0.0; ///< scalar units
  QPointF at;         ///< logical pixels
  QString label = {}; ///< what a segmentation says of the place (labelReading)
  bool operator==(const ReadValue&) const = default;
};

/// The error that was measured of the picture of a scene, levels (99.9th percentile); absent where none was.
using MeasuredErrors = std::function<std::optional<double>(const Scene& scene)>;

/// Why an engine draws.
struct EngineInUse {
  Engine engine = Engine::rayCaster;
  QString reason;               ///< one sentence; may be empty
  bool driverHasFailed = false; ///< and the processor draws in its place
  QString limitation;           ///< one sentence where the driver has no room for the volume
  bool operator==(const EngineInUse&) const = default;
};

/// Everything that decides what a view shows, pushed from the view to those who draw it whenever anything in
/// it changes. An equal order draws nothing; pictures are drawn anew only where they would be others.
struct ViewOrder {
  Comparison comparison;
  ViewGeometry geometry;
  QFont font;
  double labelOpacity = 1.0; ///< of the numbers beside the titles
  Hovered hovered;
  bool hasCropBox = false; ///< with a handle on each face
  bool hasCube = false;    ///< that shows how the picture lies
  std::optional<CropFace> heldFace;
  bool isTurning = false; ///< by a drag
  std::optional<ReadValue> read;
  std::optional<CutLine> cutLine; ///< that is being drawn
  double coveredBelow = 0.0;      ///< by a panel over the pictures' lower edge, logical pixels

  bool isSeen = false;    ///< there is something to show, and the user can see it
  bool hasOverlay = true; ///< labels, letters, scale and notes stand above the pictures
  bool refines = true;    ///< resting pictures go on to smaller steps
  double movingMs = InteractionQuality::usualTargetMs; ///< drawing time of a frame while something moves, > 0
  std::shared_ptr<const MeasuredErrors> measured;      ///< told in place of estimates; null where none were
  EngineInUse inUse;
  int attempt = 0; ///< another number: what failed or was stopped may be tried again
  bool operator==(const ViewOrder&) const = default;

  const Volume& volume() const { return *comparison.scene.volume; } ///< there is one
  QRectF view() const { return {{0.0, 0.0}, QSizeF(geometry.size)}; }
  /// Below which nothing is written.
  double lowest() const { return geometry.size.height() - coveredBelow; }
  /// The part of a picture in which something is written.
  QRectF written(int position) const {
    return pictureRect(geometry, position).adjusted(0, 0, 0, -coveredBelow);
  }
};

/// The side that is shown at a point of the view, logical pixels.
int sideAt(const ViewOrder& order, const QPointF& point);

/// What is told of pictures of an order: with the engine that draws them, and what was measured.
PictureState stateTold(PictureState state, const ViewOrder& order);

/// Everything from which follows what stands above the pictures; there is a volume.
struct OverlaySource : ViewOrder {
  PictureState state;
};

} // namespace limn
