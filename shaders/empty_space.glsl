// SPDX-License-Identifier: GPL-3.0-or-later
// How far nothing can be seen: blocks of texels know the distance, in blocks, to the nearest that may show.
// A block's range reaches a little beyond it, so no rounding here can step over a visible sample.

uniform sampler3D u_emptyDistance;
uniform vec3 u_blocksPerTexture;
uniform vec3 u_blockOffset;
uniform vec3 u_lastBlock;

// The samples of a ray in units of blocks.
struct BlockRay {
  vec3 first;   // of sample 0
  vec3 advance; // per sample
  vec3 samples; // per block along each axis; 0 where the ray does not follow the axis
  vec3 still;   // 0, and beyond all samples where the ray does not follow the axis
};

BlockRay blockRay(vec3 first, vec3 advance) {
  BlockRay ray;
  ray.first = first * u_blocksPerTexture + u_blockOffset;
  ray.advance = advance * u_blocksPerTexture;
  vec3 isStill = vec3(lessThan(abs(ray.advance), vec3(1e-20)));
  ray.samples = (1.0 - isStill) / (ray.advance + isStill);
  ray.still = isStill * 60000.0;
  return ray;
}

// The number of samples from sample i on that lie in empty blocks; 0 where this one may be seen. `alike`
// receives how many lie in those blocks or, where this one may be seen, in its own.
int emptySamples(BlockRay ray, float i, out int alike) {
  vec3 p = ray.first + i * ray.advance;
  vec3 block = clamp(floor(p), vec3(0.0), u_lastBlock);
  float distance = floor(texelFetch(u_emptyDistance, ivec3(block), 0).r * 255.0 + 0.5);
  // Leave the cube of blocks through the face ahead on each axis, the nearest first.
  float reach = max(distance, 1.0) - 0.5;
  vec3 steps = (block + 0.5 - p) * ray.samples + reach * abs(ray.samples) + ray.still;
  alike = int(clamp(ceil(min(min(steps.x, steps.y), steps.z)), 1.0, 60000.0));
  return distance > 0.0 ? alike : 0;
}

int emptySamples(BlockRay ray, float i) {
  int alike;
  return emptySamples(ray, i, alike);
}
