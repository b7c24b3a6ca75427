// SPDX-License-Identifier: GPL-3.0-or-later
// The mean extinction and the mean colour, weighted by extinction, of the transfer function between two values
// (DEFINITION section 7): exact integrals over its linear pieces, so they depend on no step and on no resolution.

// Whether anything between two scalars may have an opacity; under a look, where labels have looks of their own.
#ifdef EFFECT_LABEL_LOOKS
bool mayBeSeenBetween(float a, float b, float look) {
  vec2 low = occupancyOf(min(a, b), look);
  vec2 high = occupancyOf(max(a, b), look);
#else
bool mayBeSeenBetween(float a, float b) {
  vec2 low = occupancyOf(min(a, b));
  vec2 high = occupancyOf(max(a, b));
#endif
  return high.g + (high.r > 0.0 ? 1.0 : 0.0) > low.g;
}

float segmentOf(float scalar, out float start) {
  return segmentAt(u_functionBins, u_functionSegments, u_functionDomain, scalar, start);
}

// The means of colour times extinction (rgb) and of extinction (a) between two scalars of the segment that
// begins at `start`.
vec4 meanOfPiece(float segment, float start, float from, float to) {
  vec4 value = segmentTexel(u_functionSegments, segment, 0);
  vec4 slope = segmentTexel(u_functionSegments, segment, 1);
  bool isRising = slope.a >= 0.0;
  float faint = isRising ? from : to; // the end of less opacity
  float dense = isRising ? to : from;
  float low = clamp(value.a + (faint - start) * slope.a, 0.0, largestOpacity);
  float high = clamp(value.a + (dense - start) * slope.a, low, largestOpacity);
  float share = (high - low) / (1.0 - low);
  float extinction = minusLog1mOpacity(low);
  float mean = extinction + meanMinusLog1m(share);
  float moment = 0.5 * extinction + momentMinusLog1m(share);
  vec3 faintColor = clamp(value.rgb + (faint - start) * slope.rgb, 0.0, 1.0);
  vec3 denseColor = clamp(value.rgb + (dense - start) * slope.rgb, 0.0, 1.0);
  return vec4(faintColor * (mean - moment) + denseColor * moment, mean);
}

#ifdef EFFECT_LABEL_LOOKS
// What a step within one look has of it.
struct MeanOfLook {
  float look;
  vec3 color;
  float extinction; // per unit distance of the look
};

MeanOfLook meanOfLook(float a, float b, float look) {
#else
Material meanMaterial(float a, float b) {
#endif
  float from = min(a, b);
  float to = max(a, b);
  float firstStart, lastStart;
  float first = segmentOf(from, firstStart);
  float last = segmentOf(to, lastStart);
#ifdef EFFECT_LABEL_LOOKS
  first += look * u_lookSegments;
  last += look * u_lookSegments;
#endif
  bool isOnePiece = first == last;
  float firstEnd = isOnePiece ? to : segmentTexel(u_functionSegments, first, 2).y;
  vec4 mean = meanOfPiece(first, firstStart, from, firstEnd);
  if (!isOnePiece) {
    // Add the piece up to the first knot, the whole segments between, and the piece behind the last knot.
    vec4 sum = (firstEnd - from) * mean + (to - lastStart) * meanOfPiece(last, lastStart, lastStart, to) +
               (segmentTexel(u_functionSegments, last, 3) - segmentTexel(u_functionSegments, first + 1.0, 3));
    mean = sum / (to - from);
  }
#ifdef EFFECT_LABEL_LOOKS
  return MeanOfLook(look, mean.a > 0.0 ? clamp(mean.rgb / mean.a, 0.0, 1.0) : vec3(0.0), max(mean.a, 0.0));
#else
  Material material;
  material.extinction = max(mean.a, 0.0);
  material.opacity = oneMinusExpNeg(material.extinction);
  material.color = mean.a > 0.0 ? clamp(mean.rgb / mean.a, 0.0, 1.0) : vec3(0.0);
  return material;
#endif
}

#ifdef EFFECT_LABEL_LOOKS
// One look at the place that stands for its step, its opacity times a factor.
Mixed alikeAt(vec3 position, MeanOfLook mean, float factor) {
#ifdef EFFECT_REGION
  factor *= weightAt(position);
#endif
  float extinction = mean.extinction;
  if (factor != 1.0)
    extinction = minusLog1mOpacity(factor * oneMinusExpNeg(extinction));
  return Mixed(mean.color, extinction * u_lookUnits[int(mean.look)]);
}
#endif
