// SPDX-License-Identifier: GPL-3.0-or-later
// The integral along a ray, alone or up to a surface.

out vec4 fragColor;

#ifndef EFFECT_LOCAL_STEPS
// The ray in equal steps; where nothing is left of it, there is no sample.
Gathered gatherAlong(Ray ray, vec2 span, out int spent) {
  spent = span.y > span.x ? sampleCount(span.y - span.x) : 0;
  return gather(marchThrough(ray, span, max(spent, 1)), spent);
}
#endif

void main() {
  fragColor = vec4(0.0);
  Ray ray = rayThrough(gl_FragCoord.xy);
  vec2 span = spanInBox(ray);
  if (!(span.y > span.x))
    return;
  int spent = 0;
#ifdef EFFECT_HYBRID
  // Gather what lies before the surface in steps of its own, then put it over the surface.
  vec3 surface = vec3(0.0);
  int count = sampleCount(span.y - span.x);
  March march = marchThrough(ray, span, count);
  float hit = firstHit(march, count);
  bool isHit = hit < noHit;
  if (isHit) {
    surface = surfaceColor(march, hit);
    span.y = span.x + (hit + march.offset) * march.stepLength;
  }
  fragColor = pixelOf(gatherAlong(ray, span, spent));
  if (isHit)
    fragColor = vec4(fragColor.rgb + (1.0 - fragColor.a) * surface, 1.0);
#else
  fragColor = pixelOf(gatherAlong(ray, span, spent));
#endif
#ifdef EFFECT_SAMPLE_COUNTS
  fragColor = vec4(float(spent));
#endif
}
