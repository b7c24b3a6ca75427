// SPDX-License-Identifier: GPL-3.0-or-later
// Gather a ray by its standard discretisation (RENDERING 7): each sample stands for its step.

Gathered gather(March march, int count) {
  Gathered gathered = nothingGathered();
  for (int i = 0; i < count && !isFinished(gathered); ++i) {
    vec3 position = positionOf(march, float(i));
    float scalar = scalarAt(position);
#ifdef EFFECT_LONG_RAYS
    // One loop: drivers limit the iterations of all loops of a fragment together.
    if (mayBeSeen(scalar))
      addMaterial(gathered, march, position, materialOf(scalar), float(i));
#else
    // Find the next visible sample, then shade it: pixels that run together all shade, or all search.
    while (!mayBeSeen(scalar)) {
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
      i += max(1, emptySamples(position, march.advance));
#else
      ++i;
#endif
      if (i >= count)
        break;
      position = positionOf(march, float(i));
      scalar = scalarAt(position);
    }
    if (i < count)
      addMaterial(gathered, march, position, materialOf(scalar), float(i));
#endif
  }
  return gathered;
}
