// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorEstimate.h"
#include "accuracy/ToleranceSearch.h"
#include "widgets/view/pictures/TileSchedule.h"

#include <memory>
#include <optional>
#include <vector>

namespace limn {

class DrawingEngine;
class PictureSheet;

/// What one turn of the event loop brought while the pictures rest.
enum class RestTurn {
  nothing, ///< there is nothing left to do
  waiting, ///< for another thread
  worked,
  finished ///< something came to its end: most often a picture that was shown is replaced by a better one
};

/// The error-controlled steps with which a picture comes within a tolerance.
struct NeededSteps {
  Quality quality;
  ErrorEstimate estimate;  ///< of what its steps cost: at least the tolerance
  double expectedMs = 0.0; ///< drawing time of the picture, as small ones tell; 0 where none was needed
  bool holds = false;      ///< false: no steps come within the tolerance
};

/// Looks for the steps that pictures need (accuracy/Tolerance) in turns of an event loop: draws the small
/// pictures that tell it strip by strip, one side after the other, and compares them on other threads.
class StepSearch {
public:
  /// Pictures of `size` of the scenes are to lie within `levels`, kept as the engine does; strips should take
  /// `stripMs`. `filterBits`: of the engine's weights between voxels (DrawingFacts).
  StepSearch(const std::vector<Scene>& scenes, const glm::ivec2& size, double levels, double stripMs,
             StepControl control, int filterBits);

  /// Does a piece of at most about `budgetMs`, drawing into `sheet`; `finished` once all is found.
  RestTurn step(DrawingEngine& engine, PictureSheet& sheet, double budgetMs);

  /// What each scene needs, once the search has finished.
  std::vector<NeededSteps> found() const;

private:
  // A picture is compared beside the event loop.
  struct Job;
  // What a small picture took.
  struct Taken {
    double fineness = 0.0;
    double pixels = 0.0;
    double ms = 0.0;
  };
  struct Side {
    std::shared_ptr<ToleranceSearch> search; // its job's while there is one
    std::optional<bool> warmWith;            // whether with own weights: another program
    std::optional<TileSchedule> schedule;
    std::shared_ptr<Job> job;
    std::vector<Taken> taken;
  };

  RestTurn draw(Side& side, DrawingEngine& engine, PictureSheet& sheet, double budgetMs) const;
  double expectedMs(const Side& side) const;

  glm::ivec2 m_size;
  double m_levels;
  double m_stripMs;
  std::vector<Side> m_sides;
};

/// How long it would take to bring pictures within half a level by halving their step again and again, ms:
/// `rough` estimates each at `stepVoxels`, all of them took `pictureMs`, and each halving takes twice as long
/// as what it halves. Infinite where the smallest step is not small enough, and where nothing is known.
double msOfHalvings(const std::vector<std::optional<ErrorEstimate>>& rough, double stepVoxels,
                    double pictureMs, double smallestStepVoxels);

/// Whether pictures are sooner within a tolerance with the error-controlled steps that were found for each
/// than after `halvingMs`. Never where one cannot be brought there, or together they would take longer than
/// `patienceMs`.
bool isToleranceShorter(const std::vector<NeededSteps>& needed, double halvingMs, double patienceMs);

} // namespace limn
