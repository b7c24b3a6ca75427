// SPDX-License-Identifier: GPL-3.0-or-later
// Measure the gradient along the grid's axes, in units of the volume's range per smallest spacing.

uniform vec3 u_texel;         // one texel in texture coordinates
uniform vec3 u_gradientScale; // from a difference over two texels to the unit
uniform float u_flatModulus;  // up to here a gradient gives no normal

vec3 gradientAt(vec3 position) {
  vec3 x = vec3(u_texel.x, 0.0, 0.0);
  vec3 y = vec3(0.0, u_texel.y, 0.0);
  vec3 z = vec3(0.0, 0.0, u_texel.z);
  return u_gradientScale * vec3(scalarAt(position + x) - scalarAt(position - x),
                                scalarAt(position + y) - scalarAt(position - y),
                                scalarAt(position + z) - scalarAt(position - z));
}
