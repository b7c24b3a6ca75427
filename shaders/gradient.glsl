// SPDX-License-Identifier: GPL-3.0-or-later
// Measure the gradient along the grid's axes, in units of the volume's range per smallest spacing: of the volume, or
// where normals are smoothed of the smoothed one, whose texels lie beside the volume's and have its range.

uniform vec3 u_texel;         // one texel in texture coordinates
uniform vec3 u_gradientScale; // from a difference over two texels to the unit
uniform float u_flatModulus;  // up to here a gradient gives no normal

#ifdef EFFECT_SMOOTH_NORMALS
uniform sampler3D u_smoothedVolume;

float shapeAt(vec3 position) {
  return filtered(u_smoothedVolume, position).r;
}
#else
float shapeAt(vec3 position) {
  return scalarAt(position);
}
#endif

vec3 gradientAt(vec3 position) {
  vec3 x = vec3(u_texel.x, 0.0, 0.0);
  vec3 y = vec3(0.0, u_texel.y, 0.0);
  vec3 z = vec3(0.0, 0.0, u_texel.z);
  return u_gradientScale * vec3(shapeAt(position + x) - shapeAt(position - x),
                                shapeAt(position + y) - shapeAt(position - y),
                                shapeAt(position + z) - shapeAt(position - z));
}
