// SPDX-License-Identifier: GPL-3.0-or-later
// The gradient-opacity curve G (lecture, boundary opacity).

uniform sampler2D u_gradientBins;
uniform sampler2D u_gradientSegments;
uniform vec3 u_gradientDomain;

float gradientOpacity(float modulus) {
  return piecewise(u_gradientBins, u_gradientSegments, u_gradientDomain, modulus).a;
}
