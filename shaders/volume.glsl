// SPDX-License-Identifier: GPL-3.0-or-later
// The scalar field, normalised to 0..1 over the volume's range; texels carry a one-voxel apron extrapolated
// linearly, so that trilinear fetches one voxel beside a clamped position are the gradient of DEFINITION section 2.

uniform sampler3D u_volume;
uniform vec3 u_textureScale;  // texture coordinates per voxel
uniform vec3 u_textureOffset; // of the box's centre
uniform vec3 u_textureLower;  // of the outermost voxel centres
uniform vec3 u_textureUpper;

vec3 toTexture(vec3 centredIndex) {
  return centredIndex * u_textureScale + u_textureOffset;
}

float scalarAt(vec3 position) {
  return filtered(u_volume, position).r;
}
