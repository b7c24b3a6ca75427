// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that lies in voxels, between them: the one place that lets the driver filter. A card weighs in 8 bits
// (glsl/programs/FilterBits). Another place or level of detail is none: marching loops are no uniform control flow.

vec4 filtered(sampler3D voxels, vec3 position) {
  return textureLod(voxels, position, 0.0);
}
