// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/ErrorEstimate.h"
#include "engine/DrawingEngine.h"
#include "widgets/view/pictures/SidePicture.h"
#include "widgets/view/pictures/StepSearch.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace limn {

/// Brings final pictures whose light on its way was looked up on a grid to light that is followed: another
/// engine draws each of them once more, with the same quality, on another thread, one after the other; that
/// picture then takes its place.
class LightBeside {
public:
  /// `makeEngine` makes one that computes in memory and follows light (DrawingFacts::findsLightOfSamples);
  /// nothing is drawn where it is empty.
  explicit LightBeside(MakeEngine makeEngine) : m_makeEngine(std::move(makeEngine)) {}
  ~LightBeside() { reset(); }

  /// Other pictures come: what is under way ends.
  void reset();

  /// Goes on with pictures that `engine` drew, of which `ofSteps` tells, for each, what its steps cost.
  /// `finished` where a picture was replaced, `nothing` once all are that can be; one that fails stays.
  RestTurn step(DrawingEngine& engine, std::span<SidePicture> sides,
                const std::vector<std::optional<ErrorEstimate>>& ofSteps);

  /// Ends what is being drawn; pictures that were replaced stay.
  void leave();

  /// Whether one of the pictures is still to be replaced.
  bool isPending(std::span<const SidePicture> sides) const;

  /// Whether the picture of a side was replaced, and by how much that is off; absent where that is not known.
  bool hasReplaced(int side) const;
  std::optional<ErrorEstimate> estimate(int side) const;

private:
  struct Job;
  bool isUnderWay() const;
  bool hasNews() const; ///< a picture that replaces none yet
  std::shared_ptr<Job> begin(DrawingEngine& engine, const SidePicture& side,
                             const std::optional<ErrorEstimate>& ofSteps) const;

  MakeEngine m_makeEngine;
  std::vector<std::shared_ptr<Job>> m_jobs; ///< one per side, as far as they have begun
};

} // namespace limn
