// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorEstimate.h"
#include "widgets/view/pictures/PictureState.h"
#include "widgets/view/pictures/SidePicture.h"
#include "widgets/view/pictures/StepSearch.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace limn {

/// Brings resting pictures closer to the exact ones, on the road that small pictures show to be the shorter:
/// draws them anew once, with the error-controlled steps that half a level needs; or with half the step,
/// again and again, all sides with the same one, until they lie within half a level or nothing is gained any
/// more. Each of those passes is compared with the one before it, beside the event loop. A scene that asks
/// for a tolerance of its own goes on from there by halving. Where that proves to be too little for single
/// pixels it goes on with a quarter of the tolerance (`tighten`). Where light is physical it has twice and
/// twice as many paths followed, until their standard error is half a level. Lives where the pictures' screen
/// does.
class Refinement {
public:
  /// The smallest step drawn. By then the 99.9th percentile of the CT head lies near half a level with every
  /// model (tests/accuracy/EstimateTest), and each further halving doubles the time.
  static constexpr double smallestStepVoxels = 1.0 / 64.0;

  /// No pass is begun that would bring the drawing time of all of them beyond this, ms.
  static constexpr double patienceMs = 60000.0;

  /// The same of passes over paths, which never stop gaining.
  static constexpr double pathPatienceMs = 600000.0;

  /// The tolerance of a picture that is drawn with error-controlled steps, levels.
  static constexpr double toleranceLevels = 0.5;

  /// How often it is quartered at most. Steps of half the length have a quarter of the error, so each time
  /// takes at most twice as many samples; on the phantom and the sample 1.05 to 1.25 times as long.
  static constexpr int mostTightenings = 2;

  explicit Refinement(PictureScreen& screen) : m_sheet(screen.makeSheet()), m_stripMs(screen.stripMs()) {}

  /// Forgets everything: other pictures are wanted.
  void reset() { *this = Refinement(std::move(m_sheet), m_stripMs); }

  /// Does a piece of at most about `budgetMs`; the sides are complete at their scenes' step, whose error
  /// small pictures estimate to be `rough`, where it is known.
  RestTurn step(DrawingEngine& engine, std::span<SidePicture> sides,
                const std::vector<std::optional<ErrorEstimate>>& rough, double budgetMs);

  /// Draws sides anew that were drawn while their light was being found, once that is there, as `step` does.
  RestTurn completeLight(DrawingEngine& engine, std::span<SidePicture> sides, double budgetMs);

  /// Finds of pictures that get more paths how far off they are as they are shown by now, which passes alone
  /// tell late: each takes as long as all before it. Takes as long as some strips.
  void judgePass(DrawingEngine& engine, std::span<const SidePicture> sides);

  /// Looks for the road.
  bool isSearching() const { return m_search.has_value(); }

  /// Goes on from pictures that came to their end and were found to lie farther off than a screen hides: with
  /// a quarter of the tolerance. False where none is drawn, because the scenes have no steps by error,
  /// because that was done often enough, or because its end was another. The step that follows looks for the
  /// steps; where they take too long it ends where it ended before.
  bool tighten(DrawingEngine& engine, std::span<const SidePicture> sides);

  /// Leaves a pass or a search that is being done; the next step begins it again.
  void leavePass(std::span<SidePicture> sides);

  /// Ends here, because something failed.
  void giveUp() { m_end = RefinementEnd::failed; }

  /// The estimate for a side's finished picture, with what early ends cost; absent before the first pass.
  std::optional<ErrorEstimate> estimate(int side) const;

  /// How many paths the finished picture of a side has, and their standard error; absent where light is not
  /// physical and before the first pass.
  std::optional<PathFigures> paths(int side) const;

  /// The same of the picture as it is shown while it gets more, in part that of the pass: fewest paths and
  /// their error, as last judged, which within a pass never rises; absent before that.
  std::optional<PathFigures> pathsOnTheWay(int side) const;

  const std::optional<RefinementEnd>& end() const { return m_end; }

  /// The pictures adopted see their transfer functions, whatever they were drawn with before.
  bool hasResolved() const { return m_road == Road::tolerance && m_end.has_value(); }

private:
  enum class Road { light, halving, tolerance, paths };
  // What is computed of a pass beside the event loop.
  struct Job;
  struct Side {
    std::vector<ImageError> halvings; ///< the differences that the passes made
    ErrorEstimate steps;
    ImageError ofFilter;                 ///< where the steps are halved; a tolerance has it counted
    std::optional<ErrorEstimate> whole;  ///< with early ends and filter, once a pass is adopted
    std::optional<PathFigures> paths;    ///< of physical light
    std::optional<PathFigures> onTheWay; ///< during a pass, of those and of what it has drawn
    std::shared_ptr<Job> job;
  };

  Refinement(std::unique_ptr<PictureSheet> sheet, double stripMs)
      : m_sheet(std::move(sheet)), m_stripMs(stripMs) {}

  RestTurn chooseRoad(DrawingEngine& engine, std::span<SidePicture> sides,
                      const std::vector<std::optional<ErrorEstimate>>& rough, double budgetMs);
  void beginSearch(DrawingEngine& engine, std::span<SidePicture> sides);
  RestTurn endTightening();
  void measureFilter(DrawingEngine& engine, std::span<SidePicture> sides);
  RestTurn begin(DrawingEngine& engine, std::span<SidePicture> sides);
  RestTurn beginHalving(DrawingEngine& engine, std::span<SidePicture> sides);
  RestTurn beginTolerance(std::span<SidePicture> sides);
  RestTurn beginPaths(std::span<SidePicture> sides);
  bool compileOne(DrawingEngine& engine, std::span<SidePicture> sides);
  bool drawStrips(DrawingEngine& engine, std::span<SidePicture> sides, double budgetMs);
  bool readOne(std::span<SidePicture> sides);
  RestTurn advance(DrawingEngine& engine, std::span<SidePicture> sides, double budgetMs);
  RestTurn adoptAll(DrawingEngine& engine, std::span<SidePicture> sides);
  std::optional<RefinementEnd> endBefore(DrawingEngine& engine, std::span<SidePicture> sides,
                                         double step) const;
  bool isWithinTarget(DrawingEngine& engine, std::span<SidePicture> sides) const;

  std::unique_ptr<PictureSheet> m_sheet; ///< of small pictures
  double m_stripMs;
  std::optional<Road> m_road;
  std::optional<StepSearch> m_search;
  std::vector<NeededSteps> m_needed; ///< on the road of the tolerance, until they are drawn with
  double m_tolerance = toleranceLevels;
  int m_tightenings = 0;
  std::optional<RefinementEnd> m_looser; ///< while steps are looked for once more: where it had ended
  std::vector<Side> m_sides;
  std::optional<RefinementEnd> m_end;
  std::vector<double> m_toPrepare; ///< steps whose programs may not be compiled yet
  double m_spentMs = 0.0;          ///< by all passes
  double m_lastMs = 0.0;           ///< by the last one; at first by the pictures of the scenes' step
};

/// Whether a picture of the scene sees its transfer function (accuracy/ErrorEstimate).
bool isResolved(DrawingEngine& engine, const Scene& scene);

} // namespace limn
