// SPDX-License-Identifier: GPL-3.0-or-later
// Gather a ray from its pre-integrated steps where labels have looks of their own, in place of gather_segments.glsl: a
// step is pre-integrated within one look, and otherwise its sample stands for it (DEFINITION section 10).

// What is fetched at the ends of a step, and the look within which it lies, otherwise -1.
struct Step {
  Fetched before, behind;
  float look;
};

// At k steps behind sample 0; of rays that do not ask, at a place that stays in a software driver's cache.
Fetched fetchedAlong(March march, float k, bool isAsked) {
  return fetchedAt(isAsked ? positionOf(march, k) : u_textureLower);
}

// Between two ends that are known.
Step stepBetween(March march, int i, bool isInside, Fetched before, Fetched behind) {
  float look = lookOfCell(isInside ? positionOf(march, float(i)) : u_textureLower);
  return Step(before, behind, before.y == look && behind.y == look ? look : -1.0);
}

// Whether a step may be seen, or lies between looks: lest every step be fetched once more, those are asked by
// themselves.
bool mayBeSeen(Step here) {
  return here.look < 0.0 || mayBeSeenBetween(here.before.x, here.behind.x, here.look);
}

void addWithin(inout Gathered gathered, March march, int i, Step here) {
  MeanOfLook mean = meanOfLook(here.before.x, here.behind.x, here.look);
  Shaded piece = shadedAlike(march, positionOf(march, float(i)), mean, float(i));
  add(gathered, piece, march.units, oneMinusExpNeg(piece.extinction * march.units));
}

void addSample(inout Gathered gathered, March march, int i) {
  vec3 position = positionOf(march, float(i));
  Fetched fetched = fetchedAt(position);
  if (mayBeSeen(fetched))
    addMaterial(gathered, march, position, materialOf(fetched), float(i));
}

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
      Step here = stepBetween(march, i, true, fetchedAlong(march, float(i) - 0.5, true),
                              fetchedAlong(march, float(i) + 0.5, true));
      if (here.look < 0.0)
        addSample(gathered, march, i);
      else if (mayBeSeen(here))
        addWithin(gathered, march, i, here);
    }
    i += max(leap, 1);
  }
  return gathered;
}
#else
// Moves i to the next step that may be seen, `count` or beyond where there is none.
void findVisible(March march, int count, inout int i, inout Step here) {
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
    Fetched before = fetchedAlong(march, float(i) - 0.5, i < count);
    bool isLooking = true;
    while (isLooking) {
      here = stepBetween(march, i, i < count, before, fetchedAlong(march, float(i) + 0.5, i < count));
      isSearching = i < count && !mayBeSeen(here);
      i += isSearching ? 1 : 0;
      before = here.behind;
      isLooking = isSearching && i < end;
    }
    // A step between looks shows by its sample.
    bool isBetween = !isSearching && i < count && here.look < 0.0;
    isSearching = isSearching || (isBetween && !mayBeSeen(fetchedAlong(march, float(i), isBetween)));
    i += isBetween && isSearching ? 1 : 0;
    isSearching = isSearching && i < count;
  }
}

// Goes on to the step behind one that was added; whether it may be seen.
bool goOn(March march, int count, Gathered gathered, inout int i, inout Step here) {
  i = isFinished(gathered) ? count : i + 1;
  here = stepBetween(march, i, i < count, here.behind, fetchedAlong(march, float(i) + 0.5, i < count));
  return i < count && mayBeSeen(here);
}

// Find the next visible step, then shade until none is visible.
Gathered gather(March march, int count) {
  Gathered gathered = nothingGathered();
  int i = 0;
  Step here = Step(Fetched(0.0), Fetched(0.0), -1.0);
  findVisible(march, count, i, here);
  while (i < count) {
    bool isVisible = true;
    // First those within one look, then those between: a software driver runs the body of a loop for all rays, and
    // of one that asks at its begin once more.
    do {
      if (here.look >= 0.0) {
        do {
          addWithin(gathered, march, i, here);
          isVisible = goOn(march, count, gathered, i, here);
        } while (isVisible && here.look >= 0.0);
      }
      if (isVisible && here.look < 0.0) {
        do {
          addSample(gathered, march, i);
          isVisible = goOn(march, count, gathered, i, here);
        } while (isVisible && here.look < 0.0);
      }
    } while (isVisible);
    ++i; // that one is known
    findVisible(march, count, i, here);
  }
  return gathered;
}
#endif
