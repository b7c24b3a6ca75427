// SPDX-License-Identifier: GPL-3.0-or-later
// The transfer function from a table, in place of classification.glsl: linear between entries at equal distances,
// so what lies between two of them is lost.

uniform sampler2D u_functionBins;      // of the same table, for steps that are pre-integrated
uniform sampler2D u_functionSegments;
uniform sampler2D u_functionOccupancy; // the largest opacity in each bin, and the visible bins before it
uniform vec3 u_functionDomain; // first x, bins per unit, last bin
uniform sampler2D u_functionTable;
uniform vec2 u_tableScale; // from a scalar to the texture coordinate: the first entry's centre is 0
uniform float u_perUnitDistance;
uniform float u_tableUnits; // the step of corrected entries in unit distances

struct Material {
  vec3 color;
  float opacity;    // over the unit distance
  float extinction; // per unit distance
};

vec2 occupancyOf(float scalar) {
  return texelFetch(u_functionOccupancy, ivec2(binOf(u_functionDomain, scalar), 0), 0).rg;
}

bool mayBeSeen(float scalar) {
  return occupancyOf(scalar).r > 0.0;
}

Material materialOf(float scalar) {
  vec4 value = textureLod(u_functionTable, vec2(scalar * u_tableScale.x + u_tableScale.y, 0.5), 0.0);
  Material material;
#ifdef DECISION_CORRECTED_TABLE
  material.extinction = minusLog1mOpacity(value.a) / u_tableUnits;
  material.opacity = oneMinusExpNeg(material.extinction);
#else
  material.opacity = value.a;
  material.extinction = minusLog1mOpacity(value.a);
#endif
  material.color = clamp(value.rgb, 0.0, 1.0);
  return material;
}
