// SPDX-License-Identifier: GPL-3.0-or-later
// The transfer function: classification after interpolation.

uniform sampler2D u_functionBins;
uniform sampler2D u_functionSegments;
uniform sampler2D u_functionOccupancy; // the largest opacity in each bin
uniform vec3 u_functionDomain; // first x, bins per unit, last bin
uniform float u_perUnitDistance;

// Whether a scalar may have an opacity at all: one fetch decides it for most samples of most rays.
bool mayBeSeen(float scalar) {
  return texelFetch(u_functionOccupancy, ivec2(binOf(u_functionDomain, scalar), 0), 0).r > 0.0;
}

float opacityOf(float scalar, out float segment, out float start) {
  return piecewise(u_functionBins, u_functionSegments, u_functionDomain, scalar, segment, start);
}

vec3 colorOf(float scalar, float segment, float start) {
  return segmentTexel(u_functionSegments, segment, 1).rgb +
         (scalar - start) * segmentTexel(u_functionSegments, segment, 2).rgb;
}
