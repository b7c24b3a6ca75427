// Piecewise linear functions, exact: a row of bins gives the segment where a bin holds no knot, and where to
// look for it where it does. Layout: renderer/raycaster/PiecewiseTable.h.

const int segmentsPerRow = 256;

vec4 segmentTexel(sampler2D segments, float index, int part) {
  int i = int(index);
  return texelFetch(segments, ivec2(3 * (i % segmentsPerRow) + part, i / segmentsPerRow), 0);
}

// The value of the function at x; `segment` receives the segment's index, `start` its first x.
float piecewise(sampler2D bins, sampler2D segments, vec3 domain, float x, out float segment, out float start) {
  float bin = clamp(floor((x - domain.x) * domain.y), 0.0, domain.z);
  vec4 line = texelFetch(bins, ivec2(int(bin), 0), 0); // start, value, slope, segment
  if (line.w < 0.0) {
    // Step over the knots of this bin; at a knot the segment to its right holds.
    segment = -1.0 - line.w;
    line = segmentTexel(segments, segment, 0); // start, value, slope, end
    if (x >= line.w)
      line = segmentTexel(segments, ++segment, 0);
    if (x >= line.w)
      line = segmentTexel(segments, ++segment, 0);
    while (x >= line.w)
      line = segmentTexel(segments, ++segment, 0);
  } else {
    segment = line.w;
  }
  start = line.x;
  return line.y + (x - line.x) * line.z;
}
