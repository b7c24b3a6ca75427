// SPDX-License-Identifier: GPL-3.0-or-later
// Gather a ray by its standard discretisation (DEFINITION section 7): each sample stands for its step. What is
// fetched at a sample, and what makes a material of it, stands in the block before.

#ifdef EFFECT_LONG_RAYS
// One loop: drivers limit the iterations of all loops of a fragment together. Each either leaps over empty
// blocks or takes a sample.
Gathered gather(March march, int count) {
  Gathered gathered = nothingGathered();
  int i = 0;
  while (i < count && !isFinished(gathered)) {
    int leap = 0;
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
    leap = emptySamples(march.blocks, float(i));
#endif
    if (leap == 0) {
      vec3 position = positionOf(march, float(i));
      Fetched fetched = fetchedAt(position);
      if (mayBeSeen(fetched))
        addMaterial(gathered, march, position, materialOf(fetched), float(i));
    }
    i += max(leap, 1);
  }
  return gathered;
}
#else
// Moves i to the next sample that may be seen, `count` or beyond where there is none. A software driver runs
// the body of a loop once for rays that have ended: those fetch one texel that stays in its cache.
void findVisible(March march, int count, inout int i, inout vec3 position, inout Fetched fetched) {
  bool isSearching = i < count;
  while (isSearching) {
    int end = count;
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
    // Leap over empty blocks, which costs less than to look at a sample.
    int alike = 0;
    bool isLeaping = true;
    while (isLeaping) {
      int leap = emptySamples(march.blocks, float(i), alike);
      i += leap;
      isLeaping = leap > 0 && i < count;
    }
    end = min(i + alike, count);
#endif
    // Look at the samples of this block.
    bool isLooking = true;
    while (isLooking) {
      position = i < count ? positionOf(march, float(i)) : u_textureLower;
      fetched = fetchedAt(position);
      isSearching = i < count && !mayBeSeen(fetched);
      i += isSearching ? 1 : 0;
      isLooking = isSearching && i < end;
    }
    isSearching = isSearching && i < count;
  }
}

// Find the next visible sample, then shade until none is visible.
Gathered gather(March march, int count) {
  Gathered gathered = nothingGathered();
  int i = 0;
  vec3 position = u_textureLower;
  Fetched fetched = Fetched(0.0);
  findVisible(march, count, i, position, fetched);
  while (i < count) {
    bool isVisible = true;
#ifdef EFFECT_LABEL_LOOKS
    // First those of one look, then those where looks meet: a software driver runs the body of a loop for all rays.
    while (isVisible) {
      bool isAlike = fetched.y >= 0.0;
      while (isAlike) {
        Shaded piece = shadedAlike(march, position, materialOf(fetched), float(i));
        add(gathered, piece, march.units, oneMinusExpNeg(piece.extinction * march.units));
        i = isFinished(gathered) ? count : i + 1;
        position = i < count ? positionOf(march, float(i)) : u_textureLower;
        fetched = fetchedAt(position);
        isVisible = i < count && mayBeSeen(fetched);
        isAlike = isVisible && fetched.y >= 0.0;
      }
      bool isMixed = isVisible;
      while (isMixed) {
        addMaterial(gathered, march, position, materialOf(fetched), float(i));
        i = isFinished(gathered) ? count : i + 1;
        position = i < count ? positionOf(march, float(i)) : u_textureLower;
        fetched = fetchedAt(position);
        isVisible = i < count && mayBeSeen(fetched);
        isMixed = isVisible && fetched.y < 0.0;
      }
    }
#else
    while (isVisible) {
      addMaterial(gathered, march, position, materialOf(fetched), float(i));
      i = isFinished(gathered) ? count : i + 1;
      position = i < count ? positionOf(march, float(i)) : u_textureLower;
      fetched = fetchedAt(position);
      isVisible = i < count && mayBeSeen(fetched);
    }
#endif
    ++i; // that one is known
    findVisible(march, count, i, position, fetched);
  }
  return gathered;
}
#endif
