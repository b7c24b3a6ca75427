// SPDX-License-Identifier: GPL-3.0-or-later
// The gradient of the smoothed field, in place of gradient.glsl: its texels lie beside those of the volume and are
// normalised over the same range.

uniform sampler3D u_smoothedVolume;
uniform vec3 u_texel;         // one texel in texture coordinates
uniform vec3 u_gradientScale; // from a difference over two texels to the unit
uniform float u_flatModulus;  // up to here a gradient gives no normal

float smoothedAt(vec3 position) {
  return filtered(u_smoothedVolume, position).r;
}

vec3 gradientAt(vec3 position) {
  vec3 x = vec3(u_texel.x, 0.0, 0.0);
  vec3 y = vec3(0.0, u_texel.y, 0.0);
  vec3 z = vec3(0.0, 0.0, u_texel.z);
  return u_gradientScale * vec3(smoothedAt(position + x) - smoothedAt(position - x),
                                smoothedAt(position + y) - smoothedAt(position - y),
                                smoothedAt(position + z) - smoothedAt(position - z));
}
