// SPDX-License-Identifier: GPL-3.0-or-later
// The mean extinction and the mean colour, weighted by extinction, of the transfer function between two values
// (RENDERING 7): exact integrals over its linear pieces, so they depend on no step and on no resolution.

// Whether anything between two scalars may have an opacity.
bool mayBeSeenBetween(float a, float b) {
  vec2 low = occupancyOf(min(a, b));
  vec2 high = occupancyOf(max(a, b));
  return high.g + (high.r > 0.0 ? 1.0 : 0.0) > low.g;
}

float segmentOf(float scalar) {
  float segment, start;
  piecewise(u_functionBins, u_functionSegments, u_functionDomain, scalar, segment, start);
  return segment;
}

// The means of colour times extinction (rgb) and of extinction (a) of one segment between two scalars.
vec4 meanOfPiece(float segment, float from, float to) {
  vec4 line = segmentTexel(u_functionSegments, segment, 0); // start, opacity, slope, end
  vec3 color = segmentTexel(u_functionSegments, segment, 1).rgb;
  vec3 slope = segmentTexel(u_functionSegments, segment, 2).rgb;
  bool isRising = line.z >= 0.0;
  float faint = isRising ? from : to; // the end of less opacity
  float dense = isRising ? to : from;
  float low = clamp(line.y + (faint - line.x) * line.z, 0.0, largestOpacity);
  float high = clamp(line.y + (dense - line.x) * line.z, low, largestOpacity);
  float share = (high - low) / (1.0 - low);
  float extinction = minusLog1mOpacity(low);
  float mean = extinction + meanMinusLog1m(share);
  float moment = 0.5 * extinction + momentMinusLog1m(share);
  vec3 faintColor = clamp(color + (faint - line.x) * slope, 0.0, 1.0);
  vec3 denseColor = clamp(color + (dense - line.x) * slope, 0.0, 1.0);
  return vec4(faintColor * (mean - moment) + denseColor * moment, mean);
}

Material meanMaterial(float a, float b) {
  float from = min(a, b);
  float to = max(a, b);
  float first = segmentOf(from);
  float last = segmentOf(to);
  vec4 mean;
  if (first == last) {
    mean = meanOfPiece(first, from, to);
  } else {
    // Add the piece up to the first knot, the whole segments between, and the piece behind the last knot.
    float firstEnd = segmentTexel(u_functionSegments, first, 0).w;
    float lastStart = segmentTexel(u_functionSegments, last, 0).x;
    vec4 sum = (firstEnd - from) * meanOfPiece(first, from, firstEnd) +
               (to - lastStart) * meanOfPiece(last, lastStart, to) +
               (segmentTexel(u_functionSegments, last, 3) - segmentTexel(u_functionSegments, first + 1.0, 3));
    mean = sum / (to - from);
  }
  Material material;
  material.extinction = max(mean.a, 0.0);
  material.opacity = oneMinusExpNeg(material.extinction);
  material.color = mean.a > 0.0 ? clamp(mean.rgb / mean.a, 0.0, 1.0) : vec3(0.0);
  return material;
}
