// SPDX-License-Identifier: GPL-3.0-or-later
// The integral along a ray, alone or up to a surface.

out vec4 fragColor;

void main() {
  fragColor = vec4(0.0);
  Ray ray = rayThrough(gl_FragCoord.xy);
  vec2 span = spanInBox(ray);
  if (!(span.y > span.x))
    return;
  int count = sampleCount(span.y - span.x);
  March march = marchThrough(ray, span, count);
#ifdef EFFECT_HYBRID
  // Gather what lies before the surface in steps of its own, then put it over the surface.
  vec3 surface = vec3(0.0);
  float hit = firstHit(march, count);
  bool isHit = hit < noHit;
  if (isHit) {
    surface = surfaceColor(march, hit);
    span.y = span.x + (hit + march.offset) * march.stepMm;
    count = span.y > span.x ? sampleCount(span.y - span.x) : 0;
    if (count > 0)
      march = marchThrough(ray, span, count);
  }
  fragColor = pixelOf(gather(march, count));
  if (isHit)
    fragColor = vec4(fragColor.rgb + (1.0 - fragColor.a) * surface, 1.0);
#else
  fragColor = pixelOf(gather(march, count));
#endif
}
