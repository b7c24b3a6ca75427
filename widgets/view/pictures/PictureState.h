// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorEstimate.h"
#include "accuracy/sweep/ErrorByChance.h"
#include "engine/DrawingEngine.h"
#include "engine/Engine.h"
#include "engine/PixelRect.h"
#include "scene/PictureFigures.h"
#include "scene/Scene.h"
#include "scene/view/CompareLayout.h"
#include "widgets/properties/EffectTimes.h"
#include "widgets/view/pictures/InteractionQuality.h"

#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace limn {

/// Why the pictures at rest are not refined any further.
enum class RefinementEnd {
  withinHalfALevel, ///< of the exact picture, at the 99.9th percentile
  smallestStep,
  sampleLimit, ///< rays would need more samples than one may take
  patience,    ///< the next pass would take too long
  gridOfLight, ///< smaller steps would show nothing beside what light that is looked up on a grid is off by
  failed
};

/// How far one picture of the view is.
struct SideState {
  ShadingModel model = ShadingModel::classic;
  double fraction = 0.0;                 ///< of the picture at rest, 0..1
  double stepVoxels = 0.0;               ///< of what is shown, in units of the smallest spacing
  std::optional<double> toleranceLevels; ///< of what is shown, where its steps follow the error
  double imageScale = 1.0;               ///< of what is shown: pixels drawn per pixel of the window, each way
  std::optional<Coarseness> coarseness;  ///< where what is shown is drawn from fewer voxels than there are
  double shownMs = 0.0;                  ///< drawing time of what is shown
  std::optional<double> completeMs;      ///< drawing time of the last complete picture at rest
  std::optional<double> contrast;        ///< of the picture at rest, RMS
  std::optional<Overflow> overflow; ///< of the light before it is limited, at the scene's step; absent where
                                    ///< unlit
  std::optional<ErrorEstimate> estimate; ///< of the error of what is shown; absent while nothing is known
  bool isRough = true;                   ///< the estimate comes from small pictures
  std::optional<ErrorByChance> chance;   ///< of the error of what is shown, once it is final
  std::optional<double> measuredLevels;  ///< 99.9th percentile of the error of a smaller picture, measured
  bool isLightMeasured = true;           ///< false: what a grid of light is off by is in no figure told
  std::optional<PathFigures> paths{};    ///< of the picture at rest, where light is physical
  std::optional<PathFigures> onTheWay{}; ///< of what is shown while it gets more paths: rows of two pictures
  std::optional<double> msPerPath{};     ///< drawing time of a path of each pixel, where light is physical
  bool isResolved = true;                ///< the step sees the transfer function; otherwise no estimate holds
  bool operator==(const SideState&) const = default;
};

/// What the screen can show, levels: a difference of one in one of a thousand colour values (DEFINITION
/// section 9).
inline constexpr double screenLevels = 1.0;

/// The error that is told of a side, in levels: what chance found of this very picture, which a saved one
/// carries, too; then what was measured in a smaller one; absent while nothing is known.
inline std::optional<double> levelsOf(const SideState& side) {
  if (side.chance)
    return side.chance->levels;
  if (side.measuredLevels || !side.estimate)
    return side.measuredLevels;
  return side.estimate->p99_9;
}

/// Whether that is what was measured in a smaller picture.
inline bool tellsMeasured(const SideState& side) {
  return side.measuredLevels && !side.chance;
}

/// The error that paths tell of their picture.
inline std::optional<ErrorEstimate> estimateOf(const PathFigures& paths) {
  if (!paths.rmsLevels || !paths.p99_9Levels)
    return std::nullopt;
  return ErrorEstimate{*paths.p99_9Levels, *paths.rmsLevels, 1.0};
}

/// A side as it is told of: one that gets more paths as it stands on screen, where it is better than the
/// whole picture before.
inline SideState asShown(SideState side) {
  if (!side.onTheWay)
    return side;
  side.paths = side.onTheWay;
  side.estimate = estimateOf(*side.paths);
  return side;
}

/// The quality with which a side at rest is drawn as it stands on screen, refined or not; `asked` is its
/// scene's.
inline Quality qualityShown(Quality asked, const SideState& side) {
  asked.toleranceLevels = side.toleranceLevels;
  if (!side.toleranceLevels)
    asked.stepVoxels = side.stepVoxels;
  if (side.paths)
    asked.paths = side.paths->paths;
  return asked;
}

/// What the compare view shows at the moment, from left to right.
struct PictureState {
  std::vector<SideState> sides;
  bool resting = false; ///< every side is complete at the scene's step; it may be refined from there
  bool refines = false; ///< a better picture is being drawn, looked for, or will be
  double refinementFraction = 0.0;            ///< of the pass that is being drawn, 0..1
  std::optional<RefinementEnd> refinementEnd; ///< while resting, once no smaller step follows
  bool isFinal = false; ///< while resting: no better picture follows, and what chance says of it is known
  QString renderer;     ///< what draws, by its own name
  QString limitation;   ///< one sentence where less than the whole volume, or fewer samples, are drawn
  Engine engine = Engine::rayCaster;
  QString engineReason;         ///< one sentence: why this engine draws; may be empty
  bool driverHasFailed = false; ///< and the processor draws in its place
  bool operator==(const PictureState&) const = default;
};

/// The same state while other pictures are asked for: nothing of it is complete any more.
inline PictureState staleState(PictureState state) {
  state.resting = false;
  state.refines = false;
  state.refinementEnd.reset();
  state.isFinal = false;
  for (SideState& side : state.sides) {
    side.fraction = 0.0;
    side.chance.reset();
  }
  return state;
}

/// What comes up from the pictures whenever anything in it changes, from those who draw to the window.
struct ViewNews {
  PictureState state;
  std::vector<EffectRow> effects; ///< what the last picture calls for; empty without one
  QString effectsOf;              ///< what that is called
  EffectTimes times;
  double prepared = 1.0; ///< how far a volume is got ready, 0..1, where that takes long
  QString failure;       ///< a sentence: why nothing is drawn; empty while drawing works
  QString failureAtRest; ///< a sentence: what is done at rest failed; the pictures stay
  bool operator==(const ViewNews&) const = default;
};

/// A part of a picture's columns, as fractions of its width.
struct Columns {
  double from = 0.0;
  double to = 1.0;
  bool operator==(const Columns&) const = default;
};

/// The pictures to draw, and how they are put together on the screen. Pushed to those who draw whenever
/// anything in it changes; an equal order asks for nothing.
struct PictureOrder {
  bool isSeen = false;         ///< otherwise nothing is drawn
  int attempt = 0;             ///< another number: what failed or was stopped may be tried again
  std::vector<Scene> scenes;   ///< one or two, of one volume; there may be none
  glm::ivec2 size{0};          ///< of each picture, pixels; nothing is drawn where it is 0
  std::array<Columns, 2> seen; ///< of each picture, while something moves
  double seenShare = 1.0;      ///< of all pixels, then
  QString lastName;            ///< what the last picture is called

  CompareLayout layout = CompareLayout::single;
  std::vector<PixelRect> places; ///< one per picture, y down
  glm::ivec2 screen{0};          ///< its size, pixels
  int wipeColumn = 0;
  bool isSwapped = false; ///< left and right exchanged

  bool refines = true;                                 ///< at rest, to smaller steps
  double movingMs = InteractionQuality::usualTargetMs; ///< drawing time aimed at while something moves, > 0
  bool operator==(const PictureOrder&) const = default;
};

/// The volume of an order; null where there is none.
inline std::shared_ptr<const Volume> volumeOf(const PictureOrder& order) {
  return order.scenes.empty() ? nullptr : order.scenes.front().volume;
}

/// Whether an order asks for other pictures than the one before it, of which pictures rest or do not: what a
/// coarse picture hides was not drawn.
inline bool asksForOthers(const PictureOrder& order, const PictureOrder& before, bool isResting) {
  return order.attempt != before.attempt || order.size != before.size || order.scenes != before.scenes ||
         (!isResting && (order.seen != before.seen || order.isSeen != before.isSeen));
}

} // namespace limn
