// SPDX-License-Identifier: GPL-3.0-or-later
// Filters as a graphics card does, in place of driver_weights.glsl: the place between voxels is rounded to 1/256.

vec4 filtered(sampler3D voxels, vec3 position) {
  vec3 size = vec3(textureSize(voxels, 0));
  return textureLod(voxels, (floor((position * size - 0.5) * 256.0 + 0.5) / 256.0 + 0.5) / size, 0.0);
}
