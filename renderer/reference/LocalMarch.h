// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/BlockSteps.h"
#include "scene/steps/LocalSteps.h"
#include "scene/steps/RayFrame.h"

namespace limn {

/// What the rays of a picture in error-controlled steps share.
struct LocalStepTerms {
  BlockSteps steps;
  int fineness = 0;
  double smallestMm = 1.0;
  glm::dvec3 centre{0.0}; ///< index of the box's centre
};

/// The terms of a scene; absent where it is drawn in equal steps.
std::optional<LocalStepTerms> localStepTerms(const Scene& scene);

/// The chords of a ray in the blocks that it crosses, one after the other. Twin of shaders/local_steps.glsl,
/// which leaps over empty blocks; here each is visited.
class BlockWalk {
public:
  BlockWalk(const LocalStepTerms& terms, const FramedRay& ray, const RaySpan& span);

  /// Enters the next block in which there is anything of the ray; false behind its end.
  bool enterNext();

  const StepRungs& rungs() const { return m_rungs; }
  double entry() const { return m_entry; } ///< mm behind the span's begin
  double exit() const { return m_exit; }

private:
  const LocalStepTerms& m_terms;
  glm::dvec3 m_first;   // in blocks, at the span's begin
  glm::dvec3 m_advance; // blocks per mm
  double m_end;
  glm::ivec3 m_next;
  StepRungs m_rungs;
  double m_entry = 0.0;
  double m_exit = 0.0;
};

/// Takes the pieces of a ray one after the other, with a sample at either end of each. `sample(place)` gives
/// what lies there, `changeOver(before, here, halfMm)` how much the light that the two halves of a piece add
/// to a channel of the pixel (0..1) differs, as if either were the whole; `add(half, halfMm)` composites one
/// and gives the transmittance behind it; `isEnd()` ends the ray. Returns how many samples were taken.
template <class Half, class Sample, class Change, class Add, class IsEnd>
int marchLocally(const LocalStepTerms& terms, BlockWalk walk, const Sample& sample, const Change& changeOver,
                 const Add& add, const IsEnd& isEnd) {
  const double limit = mostChange(terms.fineness);
  int rung = 0;
  double transmittance = 1.0;
  Half before = sample(0.0);
  int spent = before == Half{} ? 0 : 1;
  while (walk.enterNext()) {
    if (walk.rungs().isEmpty) {
      before = {};
      rung = 0;
      continue;
    }
    const int blockRung = rungIn(walk.rungs(), terms.fineness, transmittance);
    rung = std::max(rung, blockRung);
    const double chord = walk.exit() - walk.entry();
    for (double within = 0.0; within < chord;) {
      const bool hasSpentAll = spent >= mostLocalSamples;
      const double rest = chord - within;
      const double length = hasSpentAll ? rest : pieceOf(rest, stepOfRung(rung) * terms.smallestMm);
      const bool isLast = length == rest;
      const Half here = sample(isLast ? walk.exit() : walk.entry() + (within + length));
      const double change = changeOver(before, here, 0.5 * length);
      ++spent;
      if (!hasSpentAll && isToBeRefined(change, limit, rung)) {
        rung = refinedRung(rung, change, limit);
        continue;
      }
      add(before, 0.5 * length);
      transmittance = add(here, 0.5 * length);
      if (isEnd())
        return spent;
      rung = relaxedRung(rung, blockRung, change, limit);
      within = isLast ? chord : within + length;
      before = here;
    }
  }
  return spent;
}

} // namespace limn
