// SPDX-License-Identifier: GPL-3.0-or-later
// Normalise the modulus by its reference and apply the curve (paper eq. 7 and 8: g/gmax).

uniform float u_perReference; // 1 / gref, 0 where gref = 0
uniform float u_curve;        // gamma or b

float gradientRatio(float modulus) {
  float r = clamp(modulus * u_perReference, 0.0, 1.0);
#ifdef EFFECT_GAMMA_CURVE
  r = gammaCurve(r, u_curve);
#endif
#ifdef EFFECT_LOG_CURVE
  r = logCurve(r, u_curve);
#endif
  return r;
}
