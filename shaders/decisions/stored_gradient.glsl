// SPDX-License-Identifier: GPL-3.0-or-later
// The gradient in one fetch, in place of gradient.glsl: vectors of voxels, made before, interpolated.

uniform sampler3D u_storedGradient;
uniform float u_gradientPerStored; // from what is stored to the unit
uniform float u_flatModulus;       // up to here a gradient gives no normal

vec3 gradientAt(vec3 position) {
  return u_gradientPerStored * filtered(u_storedGradient, position).rgb;
}
