// SPDX-License-Identifier: GPL-3.0-or-later
// What gather.glsl fetches at a sample, in place of fetched.glsl: voxels that were classified before interpolation.
// Their colours, premultiplied by opacity, are what is interpolated.

uniform sampler3D u_classifiedVolume;

#define Fetched vec4

Fetched fetchedAt(vec3 position) {
  return filtered(u_classifiedVolume, position);
}

bool mayBeSeen(Fetched classified) {
  return classified.a > 0.0;
}

Material materialOf(Fetched classified) {
  Material material;
  material.opacity = classified.a;
  material.extinction = minusLog1mOpacity(classified.a);
  material.color = clamp(classified.rgb / classified.a, 0.0, 1.0);
  return material;
}
