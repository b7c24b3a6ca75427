// SPDX-License-Identifier: GPL-3.0-or-later
// The gradient in one fetch of bytes, in place of gradient.glsl: unit directions and moduli of voxels, made
// before, interpolated apart from each other.

uniform sampler3D u_storedGradient;
uniform float u_gradientPerStored; // from a stored modulus to the unit
uniform float u_flatModulus;       // up to here a gradient gives no normal

vec3 gradientAt(vec3 position) {
  vec4 stored = filtered(u_storedGradient, position);
  return u_gradientPerStored * stored.a * safeNormal(2.0 * stored.rgb - 1.0).xyz;
}
