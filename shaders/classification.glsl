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
  float segment, start;
  Material material;
  material.opacity = piecewise(u_functionBins, u_functionSegments, u_functionDomain, scalar, segment, start);
  material.extinction = minusLog1mOpacity(material.opacity);
  vec3 color = segmentTexel(u_functionSegments, segment, 1).rgb +
               (scalar - start) * segmentTexel(u_functionSegments, segment, 2).rgb;
  material.color = clamp(color, 0.0, 1.0);
  return material;
}
