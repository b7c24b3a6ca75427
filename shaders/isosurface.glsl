// SPDX-License-Identifier: GPL-3.0-or-later
// The first surface of one value that a ray meets.

uniform float u_isovalue;
uniform vec3 u_isoColor;

const float noHit = 3e38;
const int halvings = 14; // to less than 1e-4 of a step

bool isHitAt(vec3 position) {
#ifdef EFFECT_REGION
  if (weightAt(position) < 0.5)
    return false;
#endif
  return scalarAt(position) >= u_isovalue;
}

// Where the field first reaches the isovalue in what is kept, in steps behind sample 0; noHit where it stays below.
float firstHit(March march, int count) {
  float below = -march.offset;
  float exit = float(count) - march.offset;
  if (isHitAt(positionOf(march, below)))
    return below;

  // Find the first sample at or above the isovalue; the exit counts as the last one.
  float above = noHit;
  for (int i = 0; i <= count; ++i) {
    if (isHitAt(positionOf(march, min(float(i), exit)))) {
      above = min(float(i), exit);
      break;
    }
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
    i += max(1, emptySamples(march.blocks, min(float(i), exit))) - 1;
#endif
    below = min(float(i), exit);
  }
  if (above == noHit)
    return noHit;

  // Halve the bracket.
  for (int k = 0; k < halvings; ++k) {
    float middle = 0.5 * (below + above);
    if (isHitAt(positionOf(march, middle)))
      above = middle;
    else
      below = middle;
  }
  return above;
}

vec3 surfaceColor(March march, float hit) {
  float r;
  vec4 gradient = gradientOf(positionOf(march, hit), r);
  return shaded(u_isoColor, march, gradient, r, hit);
}
