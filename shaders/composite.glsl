// SPDX-License-Identifier: GPL-3.0-or-later
// The integral of RENDERING 7 by its standard discretisation: equal steps, one sample at each midpoint.

uniform float u_lastTransmittance;

out vec4 fragColor;

#ifndef EFFECT_SAMPLE_COUNTS
bool isFinished(Gathered ray) {
#ifdef EFFECT_EARLY_TERMINATION
  return ray.transmittance * (1.0 - ray.loss) <= u_lastTransmittance;
#else
  return false;
#endif
}
#endif

void main() {
  fragColor = vec4(0.0);
  Ray ray = rayThrough(gl_FragCoord.xy);
  vec2 span = spanInBox(ray);
  if (!(span.y > span.x))
    return;
  int count = sampleCount(span.y - span.x);
#ifdef EFFECT_SAMPLE_COUNTS
  fragColor = vec4(float(count));
#else

  March march;
  march.stepMm = (span.y - span.x) / float(count);
  march.entry = ray.anchor + span.x * ray.direction;
  march.stride = march.stepMm * ray.direction;
  march.first = toTexture(march.entry);
  march.advance = march.stride * u_textureScale;
  march.fromEye = span.x - ray.eye;
  march.units = march.stepMm * u_perUnitDistance;
#ifdef EFFECT_LIGHTING
  march.light = lightAlong(ray.direction * u_spacing);
#endif

  Gathered gathered = Gathered(vec3(0.0), 1.0, 0.0);
#ifdef EFFECT_LONG_RAYS
  // One loop: drivers limit the iterations of all loops of a fragment together.
  for (int i = 0; i < count && !isFinished(gathered); ++i) {
    vec3 position = positionOf(march, float(i));
    float scalar = scalarAt(position);
    if (mayBeSeen(scalar))
      addSample(gathered, march, position, scalar, float(i));
  }
#else
  // Find the next visible sample, then shade it: pixels that run together all shade, or all search.
  for (int i = 0; i < count && !isFinished(gathered); ++i) {
    vec3 position = positionOf(march, float(i));
    float scalar = scalarAt(position);
    while (!mayBeSeen(scalar) && ++i < count) {
      position = positionOf(march, float(i));
      scalar = scalarAt(position);
    }
    if (i < count)
      addSample(gathered, march, position, scalar, float(i));
  }
#endif
  float transmittance = gathered.transmittance;
  fragColor = vec4(gathered.color, (1.0 - transmittance) + transmittance * gathered.loss);
#endif
}
