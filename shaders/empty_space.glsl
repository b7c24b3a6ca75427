// SPDX-License-Identifier: GPL-3.0-or-later
// How far nothing can be seen: blocks of texels know the distance, in blocks, to the nearest that may show.
// A block's range reaches half a texel beyond it, so no rounding here can step over a visible sample.

uniform sampler3D u_emptyDistance;
uniform vec3 u_blocksPerTexture;
uniform vec3 u_blockOffset;

// The number of samples from this one on that lie in empty blocks; 0 where this one may be seen.
int emptySamples(vec3 position, vec3 advance) {
  vec3 p = position * u_blocksPerTexture + u_blockOffset;
  vec3 block = floor(p);
  float distance = floor(texelFetch(u_emptyDistance, ivec3(block), 0).r * 255.0 + 0.5);
  vec3 stride = advance * u_blocksPerTexture;
  bvec3 isStill = lessThan(abs(stride), vec3(1e-20));
  // Leave the cube of empty blocks through the face ahead on each axis, the nearest first.
  vec3 face = block + mix(vec3(1.0) - distance, vec3(distance), greaterThan(stride, vec3(0.0)));
  vec3 steps = mix((face - p) / mix(stride, vec3(1.0), isStill), vec3(60000.0), isStill);
  float nearest = ceil(min(min(steps.x, steps.y), steps.z));
  return distance > 0.0 ? int(clamp(nearest, 1.0, 60000.0)) : 0;
}
