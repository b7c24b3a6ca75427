// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorEstimate.h"
#include "engine/StandIn.h"
#include "scene/PictureFigures.h"
#include "scene/Scene.h"

#include <QString>

#include <optional>
#include <vector>

namespace limn {

/// Why the pictures at rest are not refined any further.
enum class RefinementEnd {
  withinHalfALevel, ///< of the exact picture, at the 99.9th percentile
  smallestStep,
  sampleLimit, ///< rays would need more samples than one may take
  patience,    ///< the next pass would take too long
  failed
};

/// Which of its two engines draws a view.
enum class ViewEngine { driver, processor };

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
  std::optional<double> measuredLevels;  ///< error of what is shown, 99.9th percentile, where it was measured
  bool isResolved = true;                ///< the step sees the transfer function; otherwise no estimate holds
  bool operator==(const SideState&) const = default;
};

/// The error that is told of a side, in levels: the measured one where there is one; absent while nothing is
/// known.
inline std::optional<double> levelsOf(const SideState& side) {
  if (side.measuredLevels || !side.estimate)
    return side.measuredLevels;
  return side.estimate->p99_9;
}

/// The quality with which a side at rest is drawn as it stands on screen, refined or not; `asked` is its
/// scene's.
inline Quality qualityShown(Quality asked, const SideState& side) {
  asked.toleranceLevels = side.toleranceLevels;
  if (!side.toleranceLevels)
    asked.stepVoxels = side.stepVoxels;
  return asked;
}

/// What the compare view shows at the moment, from left to right.
struct PictureState {
  std::vector<SideState> sides;
  bool resting = false; ///< every side is complete at the scene's step; it may be refined from there
  bool refines = false; ///< a better picture is being drawn, looked for, or will be
  double refinementFraction = 0.0;            ///< of the pass that is being drawn, 0..1
  std::optional<RefinementEnd> refinementEnd; ///< while resting, once no smaller step follows
  QString renderer;                           ///< what draws, by its own name
  QString limitation; ///< one sentence where less than the whole volume, or fewer samples, are drawn
  ViewEngine engine = ViewEngine::driver;
  QString engineReason;         ///< one sentence: why this engine draws; may be empty
  bool driverHasFailed = false; ///< and the processor draws in its place
  bool operator==(const PictureState&) const = default;
};

} // namespace limn
