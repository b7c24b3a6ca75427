// SPDX-License-Identifier: GPL-3.0-or-later
// Gather a ray from its pre-integrated steps (RENDERING 7): the field is taken as linear within each.

// The values at the ends of step i are those half a step before and behind its sample.
Gathered gather(March march, int count) {
  Gathered gathered = nothingGathered();
  vec3 border = positionOf(march, -0.5);
  float before = scalarAt(border);
  for (int i = 0; i < count && !isFinished(gathered); ++i) {
    vec3 next = positionOf(march, float(i) + 0.5);
    float behind = scalarAt(next);
#ifdef EFFECT_LONG_RAYS
    if (mayBeSeenBetween(before, behind))
      addMaterial(gathered, march, positionOf(march, float(i)), meanMaterial(before, behind), float(i));
#else
    // Find the next visible step, then shade it.
    while (!mayBeSeenBetween(before, behind)) {
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
      // All steps that end in the empty blocks around this border are empty.
      int skipped = max(1, emptySamples(next, march.advance));
      i += skipped;
      if (skipped > 1) {
        next = positionOf(march, float(i) - 0.5);
        behind = scalarAt(next);
      }
#else
      ++i;
#endif
      if (i >= count)
        break;
      before = behind;
      next = positionOf(march, float(i) + 0.5);
      behind = scalarAt(next);
    }
    if (i < count)
      addMaterial(gathered, march, positionOf(march, float(i)), meanMaterial(before, behind), float(i));
#endif
    before = behind;
  }
  return gathered;
}
