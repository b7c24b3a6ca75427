// SPDX-License-Identifier: GPL-3.0-or-later
// The transfer function: classification after interpolation.

uniform sampler2D u_functionBins;
uniform sampler2D u_functionSegments;
uniform sampler2D u_functionOccupancy; // the largest opacity in each bin, and the visible bins before it
uniform vec3 u_functionDomain; // first x, bins per unit, last bin
uniform float u_perUnitDistance;

struct Material {
  vec3 color;
  float opacity;    // over the unit distance
  float extinction; // per unit distance
};

vec2 occupancyOf(float scalar) {
  return texelFetch(u_functionOccupancy, ivec2(binOf(u_functionDomain, scalar), 0), 0).rg;
}

// Whether a scalar may have an opacity at all: one fetch decides it for most samples of most rays.
bool mayBeSeen(float scalar) {
  return occupancyOf(scalar).r > 0.0;
}

Material materialOf(float scalar) {
  vec4 value = piecewise(u_functionBins, u_functionSegments, u_functionDomain, scalar);
  Material material;
  material.opacity = value.a;
  material.extinction = minusLog1mOpacity(value.a);
  material.color = clamp(value.rgb, 0.0, 1.0);
  return material;
}
