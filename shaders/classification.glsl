// The transfer function: classification after interpolation.

uniform sampler2D u_functionBins;
uniform sampler2D u_functionSegments;
uniform vec3 u_functionDomain; // first x, bins per unit, last bin
uniform float u_perUnitDistance;

float opacityOf(float scalar, out float segment, out float start) {
  return piecewise(u_functionBins, u_functionSegments, u_functionDomain, scalar, segment, start);
}

vec3 colorOf(float scalar, float segment, float start) {
  return segmentTexel(u_functionSegments, segment, 1).rgb +
         (scalar - start) * segmentTexel(u_functionSegments, segment, 2).rgb;
}
