// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of the first surface of one value.

out vec4 fragColor;

void main() {
  fragColor = vec4(0.0);
  Ray ray = rayThrough(gl_FragCoord.xy);
  vec2 span = spanInBox(ray);
  if (!(span.y > span.x))
    return;
  int count = sampleCount(span.y - span.x);
  March march = marchThrough(ray, span, count);
  float hit = firstHit(march, count);
  if (hit < noHit)
    fragColor = vec4(surfaceColor(march, hit), 1.0);
}
