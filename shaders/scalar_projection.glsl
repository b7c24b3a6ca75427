// SPDX-License-Identifier: GPL-3.0-or-later
// One scalar of each ray, the largest, the smallest or the mean, classified once.

out vec4 fragColor;

bool isKept(vec3 position) {
#ifdef EFFECT_REGION
  return weightAt(position) >= 0.5;
#else
  return true;
#endif
}

// Of the samples that are kept; `isAny` where there are some.
float projected(March march, int count, out bool isAny) {
#ifdef EFFECT_AVERAGE
  // Carry what each addition loses to rounding.
  float sum = 0.0;
  float lost = 0.0;
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    vec3 position = positionOf(march, float(i));
    if (isKept(position)) {
      float term = scalarAt(position) - lost;
      float next = sum + term;
      lost = (next - sum) - term;
      sum = next;
      ++kept;
    }
  }
  isAny = kept > 0;
  return sum / float(max(kept, 1));
#else
  // Nothing exceeds the volume's own range, 0..1.
#ifdef EFFECT_MIP
  float extreme = -1.0;
  for (int i = 0; i < count && extreme < 1.0; ++i) {
    vec3 position = positionOf(march, float(i));
    if (isKept(position))
      extreme = max(extreme, scalarAt(position));
  }
  isAny = extreme > -1.0;
#else
  float extreme = 2.0;
  for (int i = 0; i < count && extreme > 0.0; ++i) {
    vec3 position = positionOf(march, float(i));
    if (isKept(position))
      extreme = min(extreme, scalarAt(position));
  }
  isAny = extreme < 2.0;
#endif
  return extreme;
#endif
}

void main() {
  fragColor = vec4(0.0);
  Ray ray = rayThrough(gl_FragCoord.xy);
  vec2 span = spanInBox(ray);
  if (!(span.y > span.x))
    return;
  int count = sampleCount(span.y - span.x);
  bool isAny;
  Material material = materialOf(projected(marchThrough(ray, span, count), count, isAny));
  fragColor = isAny ? vec4(material.opacity * material.color, material.opacity) : vec4(0.0);
}
