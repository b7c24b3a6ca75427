// SPDX-License-Identifier: GPL-3.0-or-later
// Fog weighs the object's colour by its distance to the eye (lecture, "OpenGL Fog"). Distances count from the anchor
// plane, z as well as start and end: from a far eye a float would not tell them apart.

uniform vec3 u_fogColor;
uniform float u_fogStart;
uniform float u_fogEnd;
uniform float u_fogDensity;

vec3 fogged(vec3 color, float z) {
#ifdef EFFECT_FOG_LINEAR
  float f = fogLinear(z, u_fogStart, u_fogEnd);
#endif
#ifdef EFFECT_FOG_EXP
  float f = fogExp(z, u_fogStart, u_fogDensity);
#endif
#ifdef EFFECT_FOG_EXP2
  float f = fogExp2(z, u_fogStart, u_fogDensity);
#endif
  return color + (1.0 - f) * (u_fogColor - color);
}
