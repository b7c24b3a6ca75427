// SPDX-License-Identifier: GPL-3.0-or-later
// Piecewise linear functions, exact: a row of bins leads to the segment between two knots, which takes two
// fetches more. Layout: renderer/scene/function/PiecewiseTable.h. No loop but for functions that crowd more than two
// knots into a bin: drivers limit the iterations of all loops together.

const int segmentsPerRow = 256;

vec4 segmentTexel(sampler2D segments, float index, int part) {
  int i = int(index);
  return texelFetch(segments, ivec2(4 * (i % segmentsPerRow) + part, i / segmentsPerRow), 0);
}

int binOf(vec3 domain, float x) {
  return int(clamp(floor((x - domain.x) * domain.y), 0.0, domain.z));
}

// The index of the segment that holds x; `start` receives its first x.
float segmentAt(sampler2D bins, sampler2D segments, vec3 domain, float x, out float start) {
  vec4 bin = texelFetch(bins, ivec2(binOf(domain, x), 0), 0); // start, first knot, second knot, segment
  // Step over the knots of this bin; at a knot the segment to its right holds.
  start = x >= bin.z ? bin.z : x >= bin.y ? bin.y : bin.x;
  float segment = bin.w + (x >= bin.y ? 1.0 : 0.0) + (x >= bin.z ? 1.0 : 0.0);
#ifdef EFFECT_DENSE_FUNCTIONS
  vec2 bounds = segmentTexel(segments, segment, 2).xy;
  while (x >= bounds.y)
    bounds = segmentTexel(segments, ++segment, 2).xy;
  start = bounds.x;
#endif
  return segment;
}

// The values of the function at x, rgb and opacity.
vec4 piecewise(sampler2D bins, sampler2D segments, vec3 domain, float x) {
  float start;
  float segment = segmentAt(bins, segments, domain, x, start);
  return segmentTexel(segments, segment, 0) + (x - start) * segmentTexel(segments, segment, 1);
}
