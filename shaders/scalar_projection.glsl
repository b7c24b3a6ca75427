// SPDX-License-Identifier: GPL-3.0-or-later
// One scalar of each ray, the largest, the smallest or the mean, classified once.

out vec4 fragColor;

float projected(March march, int count) {
#ifdef EFFECT_AVERAGE
  // Carry what each addition loses to rounding.
  float sum = 0.0;
  float lost = 0.0;
  for (int i = 0; i < count; ++i) {
    float term = scalarAt(positionOf(march, float(i))) - lost;
    float next = sum + term;
    lost = (next - sum) - term;
    sum = next;
  }
  return sum / float(count);
#else
  // Start from a sample: values may all be negative. Nothing exceeds the volume's own range, 0..1.
  float extreme = scalarAt(positionOf(march, 0.0));
#ifdef EFFECT_MIP
  for (int i = 1; i < count && extreme < 1.0; ++i)
    extreme = max(extreme, scalarAt(positionOf(march, float(i))));
#else
  for (int i = 1; i < count && extreme > 0.0; ++i)
    extreme = min(extreme, scalarAt(positionOf(march, float(i))));
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
  Material material = materialOf(projected(marchThrough(ray, span, count), count));
  fragColor = vec4(material.opacity * material.color, material.opacity);
}
