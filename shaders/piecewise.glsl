// SPDX-License-Identifier: GPL-3.0-or-later
// Piecewise linear functions, exact: a row of bins gives the segment where a bin holds no knot, and where to
// look for it where it does. Layout: renderer/raycaster/PiecewiseTable.h. No loop but for functions that crowd
// more than two knots into a bin: drivers limit the iterations of all loops together.

const int segmentsPerRow = 256;

vec4 segmentTexel(sampler2D segments, float index, int part) {
  int i = int(index);
  return texelFetch(segments, ivec2(4 * (i % segmentsPerRow) + part, i / segmentsPerRow), 0);
}

int binOf(vec3 domain, float x) {
  return int(clamp(floor((x - domain.x) * domain.y), 0.0, domain.z));
}

// The value of the function at x; `segment` receives the segment's index, `start` its first x.
float piecewise(sampler2D bins, sampler2D segments, vec3 domain, float x, out float segment, out float start) {
  vec4 line = texelFetch(bins, ivec2(binOf(domain, x), 0), 0); // start, value, slope, segment
  if (line.w < 0.0) {
    // Step over the knots of this bin; at a knot the segment to its right holds.
    segment = -1.0 - line.w;
    line = segmentTexel(segments, segment, 0); // start, value, slope, end
    if (x >= line.w)
      line = segmentTexel(segments, ++segment, 0);
    if (x >= line.w)
      line = segmentTexel(segments, ++segment, 0);
#ifdef EFFECT_DENSE_FUNCTIONS
    while (x >= line.w)
      line = segmentTexel(segments, ++segment, 0);
#endif
  } else {
    segment = line.w;
  }
  start = line.x;
  return line.y + (x - line.x) * line.z;
}
