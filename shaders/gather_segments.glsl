// SPDX-License-Identifier: GPL-3.0-or-later
// Gather a ray from its pre-integrated steps (DEFINITION section 7): the field is taken as linear within each. The ends
// of step i lie half a step before and behind its sample.

#ifdef EFFECT_LONG_RAYS
// One loop: drivers limit the iterations of all loops of a fragment together. Each either leaps over the
// steps both of whose ends lie in empty blocks or takes a step.
Gathered gather(March march, int count) {
  Gathered gathered = nothingGathered();
  int i = 0;
  while (i < count && !isFinished(gathered)) {
    int leap = 0;
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
    leap = max(emptySamples(march.blocks, float(i) - 0.5) - 1, 0);
#endif
    if (leap == 0) {
      float before = scalarAt(positionOf(march, float(i) - 0.5));
      float behind = scalarAt(positionOf(march, float(i) + 0.5));
      if (mayBeSeenBetween(before, behind))
        addMaterial(gathered, march, positionOf(march, float(i)), meanMaterial(before, behind), float(i));
    }
    i += max(leap, 1);
  }
  return gathered;
}
#else
// The scalar k steps behind sample 0; of rays that have ended, one that stays in a software driver's cache.
float endOfStep(March march, float k, bool isInside) {
  return scalarAt(isInside ? positionOf(march, k) : u_textureLower);
}

// Moves i to the next step that may be seen, `count` or beyond where there is none; `before` and `behind`
// receive the scalars at its ends.
void findVisible(March march, int count, inout int i, inout float before, inout float behind) {
  bool isSearching = i < count;
  while (isSearching) {
    int end = count;
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
    // Leap over the steps both of whose ends lie in empty blocks.
    int alike = 0;
    bool isLeaping = true;
    while (isLeaping) {
      int leap = max(emptySamples(march.blocks, float(i) - 0.5, alike) - 1, 0);
      i += leap;
      isLeaping = leap > 0 && i < count;
    }
    end = min(i + alike, count);
#endif
    // Look at the steps that begin in this block.
    before = endOfStep(march, float(i) - 0.5, i < count);
    bool isLooking = true;
    while (isLooking) {
      behind = endOfStep(march, float(i) + 0.5, i < count);
      isSearching = i < count && !mayBeSeenBetween(before, behind);
      i += isSearching ? 1 : 0;
      before = isSearching ? behind : before;
      isLooking = isSearching && i < end;
    }
    isSearching = isSearching && i < count;
  }
}

// Find the next visible step, then shade until none is visible.
Gathered gather(March march, int count) {
  Gathered gathered = nothingGathered();
  int i = 0;
  float before = 0.0;
  float behind = 0.0;
  findVisible(march, count, i, before, behind);
  while (i < count) {
    bool isVisible = true;
    while (isVisible) {
      addMaterial(gathered, march, positionOf(march, float(i)), meanMaterial(before, behind), float(i));
      i = isFinished(gathered) ? count : i + 1;
      before = behind;
      behind = endOfStep(march, float(i) + 0.5, i < count);
      isVisible = i < count && mayBeSeenBetween(before, behind);
    }
    ++i; // that one is known
    findVisible(march, count, i, before, behind);
  }
  return gathered;
}
#endif
