// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of a ray (DEFINITION section 7): equal steps, one sample in the middle of each.

// What all samples of a ray share. Sample 0 lies half a step behind the entry.
struct March {
  vec3 first;      // texture coordinates of sample 0
  vec3 advance;    // per sample
  vec3 firstIndex; // centred index of sample 0
  vec3 stride;     // per sample
  float depth;     // of sample 0: its distance from the eye less that of the anchor plane
  float stepLength;
  float units;     // step in unit distances
  float offset;    // of sample 0 behind the entry, in steps
#ifdef EFFECT_LIGHTING
#ifndef EFFECT_TRAVELLING_LIGHT
  Light light; // others work it out from the stride (lightOf)
#endif
#endif
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
  BlockRay blocks;
#endif
};

March marchThrough(Ray ray, vec2 span, int count) {
  March march;
#ifdef EFFECT_JITTER
  march.offset = jitteredOffset(gl_FragCoord.xy);
#else
  march.offset = 0.5;
#endif
  march.stepLength = (span.y - span.x) / float(count);
  march.stride = march.stepLength * ray.direction;
  march.firstIndex = ray.anchor + span.x * ray.direction + march.offset * march.stride;
  march.advance = march.stride * u_textureScale;
  march.first = toTexture(ray.anchor + span.x * ray.direction) + march.offset * march.advance;
  march.depth = span.x + ray.aside + march.offset * march.stepLength;
  march.units = march.stepLength * u_perUnitDistance;
#ifdef EFFECT_LIGHTING
#ifndef EFFECT_TRAVELLING_LIGHT
  march.light = lightAlong(ray.direction * u_spacing);
#endif
#endif
#ifdef EFFECT_EMPTY_SPACE_SKIPPING
  march.blocks = blockRay(march.first, march.advance);
#endif
  return march;
}

#ifdef EFFECT_LOCAL_STEPS
// A march whose steps are lengths of 1, from a place on: for samples that know their own step.
March marchFrom(Ray ray, float begin) {
  March march;
  march.offset = 0.0;
  march.stepLength = 1.0;
  march.stride = ray.direction;
  march.firstIndex = ray.anchor + begin * ray.direction;
  march.advance = march.stride * u_textureScale;
  march.first = toTexture(march.firstIndex);
  march.depth = begin + ray.aside;
  march.units = u_perUnitDistance;
#ifdef EFFECT_LIGHTING
#ifndef EFFECT_TRAVELLING_LIGHT
  march.light = lightAlong(ray.direction * u_spacing);
#endif
#endif
  return march;
}
#endif

// Texture coordinates `i` steps behind sample 0; clamped, because the field ends at the outermost centres. Where
// samples look about them a ray holds as few numbers as it can: a card draws as many rays at once as have room.
vec3 positionOf(March march, float i) {
#ifdef EFFECT_TRAVELLING_LIGHT
  return clamp(toTexture(march.firstIndex + i * march.stride), u_textureLower, u_textureUpper);
#else
  return clamp(march.first + i * march.advance, u_textureLower, u_textureUpper);
#endif
}

#ifdef EFFECT_LIGHTING
// What lighting needs of the ray.
Light lightOf(March march) {
#ifdef EFFECT_TRAVELLING_LIGHT
  return lightAlong(march.stride * u_spacing / march.stepLength);
#else
  return march.light;
#endif
}
#endif
