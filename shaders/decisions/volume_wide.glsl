// SPDX-License-Identifier: GPL-3.0-or-later
// The scalar field from a fixed-point texture, in place of volume.glsl: its 0..1 stand for -1..2, because the
// apron's extrapolated texels reach beyond the volume's range by up to the range itself.

uniform sampler3D u_volume;
uniform vec3 u_textureScale;  // texture coordinates per voxel
uniform vec3 u_textureOffset; // of the box's centre
uniform vec3 u_textureLower;  // of the outermost voxel centres
uniform vec3 u_textureUpper;

vec3 toTexture(vec3 centredIndex) {
  return centredIndex * u_textureScale + u_textureOffset;
}

float scalarAt(vec3 position) {
  return 3.0 * filtered(u_volume, position).r - 1.0;
}
