// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorEstimate.h"
#include "widgets/view/pictures/PictureState.h"
#include "widgets/view/pictures/SidePicture.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace limn {

/// What one turn of the event loop brought while the pictures rest.
enum class RestTurn {
  nothing, ///< there is nothing left to do
  waiting, ///< for another thread
  worked,
  finished ///< a picture that was shown is replaced by a better one
};

/// Brings resting pictures closer to the exact ones: draws them anew with half the step, again and again, all
/// sides with the same one, until they lie within half a level or nothing is gained any more. Each pass is
/// compared with the one before it, beside the event loop. Lives where the pictures' screen does.
class Refinement {
public:
  /// The smallest step drawn. By then the 99.9th percentile of the CT head lies near half a level with every
  /// model (tests/accuracy/EstimateTest), and each further halving doubles the time.
  static constexpr double smallestStepVoxels = 1.0 / 64.0;

  /// No pass is begun that would bring the drawing time of all of them beyond this, ms.
  static constexpr double patienceMs = 60000.0;

  /// Forgets everything: other pictures are wanted.
  void reset() { *this = Refinement(); }

  /// Does a piece of at most about `budgetMs`; the sides are complete at their scenes' step.
  RestTurn step(DrawingEngine& engine, std::span<SidePicture> sides, double budgetMs);

  /// Leaves a pass that is being drawn; the next step begins it again.
  void leavePass(std::span<SidePicture> sides);

  /// Ends here, because something failed.
  void giveUp() { m_end = RefinementEnd::failed; }

  /// The estimate for a side's finished picture, with what early ends cost; absent before the first pass.
  std::optional<ErrorEstimate> estimate(int side) const;

  const std::optional<RefinementEnd>& end() const { return m_end; }

private:
  // What is computed of a pass beside the event loop.
  struct Job;
  struct Side {
    std::vector<ImageError> halvings; ///< the differences that the passes made
    ErrorEstimate steps;
    ErrorEstimate whole;
    std::shared_ptr<Job> job;
  };

  RestTurn begin(DrawingEngine& engine, std::span<SidePicture> sides);
  bool compileOne(DrawingEngine& engine, std::span<SidePicture> sides);
  bool drawStrips(DrawingEngine& engine, std::span<SidePicture> sides, double budgetMs);
  bool readOne(std::span<SidePicture> sides);
  RestTurn adoptAll(std::span<SidePicture> sides);
  std::optional<RefinementEnd> endBefore(DrawingEngine& engine, std::span<SidePicture> sides,
                                         double step) const;
  bool isWithinTarget(DrawingEngine& engine, std::span<SidePicture> sides) const;

  std::vector<Side> m_sides;
  std::optional<RefinementEnd> m_end;
  std::vector<double> m_toPrepare; ///< steps whose programs may not be compiled yet
  double m_spentMs = 0.0;          ///< by all passes
  double m_lastMs = 0.0;           ///< by the last one; at first by the pictures of the scenes' step
};

/// Whether a picture of the scene sees its transfer function (accuracy/ErrorEstimate).
bool isResolved(DrawingEngine& engine, const Scene& scene);

} // namespace limn
