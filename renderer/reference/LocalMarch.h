// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/BlockWalk.h"

namespace limn {

/// Takes the pieces of a ray one after the other, with a sample at either end of each. `sample(place)` gives
/// what lies there, `changeOver(before, here, halfMm)` how much the light that the two halves of a piece add
/// to a channel of the pixel (0..1) differs, as if either were the whole; `add(half, halfMm)` composites one
/// and gives the transmittance behind it; `isEnd()` ends the ray. Behind `most` samples each block gets one.
/// Returns how many samples were taken.
template <class Half, class Sample, class Change, class Add, class IsEnd>
int marchLocally(const LocalStepTerms& terms, BlockWalk walk, const Sample& sample, const Change& changeOver,
                 const Add& add, const IsEnd& isEnd, int most = mostLocalSamples) {
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
      const bool hasSpentAll = spent >= most;
      const double rest = chord - within;
      const double length = hasSpentAll ? rest : pieceOf(rest, terms.stepMm(rung));
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
