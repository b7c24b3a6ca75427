// SPDX-License-Identifier: GPL-3.0-or-later
// The gradient by forward differences, in place of gradient.glsl: four fetches, of order 1, half a voxel aside.

uniform vec3 u_texel;         // one texel in texture coordinates
uniform vec3 u_gradientScale; // from a difference over two texels to the unit
uniform float u_flatModulus;  // up to here a gradient gives no normal

vec3 gradientAt(vec3 position) {
  float here = scalarAt(position);
  return 2.0 * u_gradientScale * vec3(scalarAt(position + vec3(u_texel.x, 0.0, 0.0)) - here,
                                      scalarAt(position + vec3(0.0, u_texel.y, 0.0)) - here,
                                      scalarAt(position + vec3(0.0, 0.0, u_texel.z)) - here);
}
