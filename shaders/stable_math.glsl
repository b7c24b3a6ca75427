// SPDX-License-Identifier: GPL-3.0-or-later
// Twins of renderer/scene/basics/StableMath.h in float, under the same names.

const float largestOpacity = 1.0 - 1.0 / 16777216.0;
const float shortestHalfVector = 1e-6;
const float log2OfE = 1.4426950408889634;

float oneMinusExpNeg(float x) {
  // Below the bound the series is exact to the last bit; above it the difference has lost at most two.
  if (x < 0.25)
    return x * (1.0 - x * (1.0 / 2.0 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0 - x * (1.0 / 720.0))))));
  return 1.0 - exp2(-x * log2OfE);
}

// log((1+z)/(1-z)) for |z| <= 1/3, where the series is exact to rounding.
float logOfRatio(float z) {
  float s = z * z;
  return 2.0 * z *
         (1.0 + s * (1.0 / 3.0 + s * (1.0 / 5.0 + s * (1.0 / 7.0 + s * (1.0 / 9.0 + s * (1.0 / 11.0 + s * (1.0 / 13.0)))))));
}

float minusLog1mOpacity(float a) {
  a = clamp(a, 0.0, largestOpacity);
  return a > 0.5 ? -log(1.0 - a) : logOfRatio(a / (2.0 - a));
}

// -integral of log(1 - x s) over s in 0..1, for 0 <= x <= largestOpacity.
float meanMinusLog1m(float x) {
  if (x < 0.25)
    return x * (1.0 / 2.0 + x * (1.0 / 6.0 + x * (1.0 / 12.0 + x * (1.0 / 20.0 + x * (1.0 / 30.0 + x * (1.0 / 42.0 +
           x * (1.0 / 56.0 + x * (1.0 / 72.0 + x * (1.0 / 90.0 + x * (1.0 / 110.0))))))))));
  return 1.0 - (1.0 - x) * minusLog1mOpacity(x) / x;
}

// -integral of s log(1 - x s) over s in 0..1, for 0 <= x <= largestOpacity.
float momentMinusLog1m(float x) {
  if (x < 0.25)
    return x * (1.0 / 3.0 + x * (1.0 / 8.0 + x * (1.0 / 15.0 + x * (1.0 / 24.0 + x * (1.0 / 35.0 + x * (1.0 / 48.0 +
           x * (1.0 / 63.0 + x * (1.0 / 80.0 + x * (1.0 / 99.0 + x * (1.0 / 120.0))))))))));
  return (0.5 + 0.25 * x - (1.0 - x) * (1.0 + x) * minusLog1mOpacity(x) / (2.0 * x)) / x;
}

vec4 safeNormal(vec3 v) {
  float m = max(max(abs(v.x), abs(v.y)), abs(v.z));
  if (!(m > 1e-37) || !(m < 3e38))
    return vec4(0.0);
  vec3 q = v / m;
  float l = length(q);
  return vec4(q / l, m * l);
}

float blinnTerm(float cosine, float exponent) {
  // The logarithm keeps its digits near 1, where the power is sensitive, and near 0, where 1 - cosine has none left;
  // no pow, whose edge cases differ between drivers.
  if (!(cosine > 0.0))
    return 0.0;
  float c = min(cosine, 1.0);
  float depth = c < 0.5 ? -log(c) : logOfRatio((1.0 - c) / (1.0 + c));
  return exp2(-exponent * log2OfE * depth);
}

vec3 knee(vec3 color, float k) {
  float m = max(max(color.r, color.g), color.b);
  if (!(m > k))
    return color;
  float d = 1.0 - k;
  return color * ((1.0 - d * d / (m + 1.0 - 2.0 * k)) / m);
}

float energyFactor(float exponent, float largestExponent) {
  return (exponent + 8.0) / (largestExponent + 8.0);
}

float significanceWeight(float low, float high, float r) {
  if (!(high > low))
    return r >= high ? 1.0 : 0.0;
  float x = clamp((r - low) / (high - low), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

float gammaCurve(float r, float gamma) {
  return r > 0.0 ? exp2(gamma * log2(r)) : 0.0;
}

float logOnePlus(float x) {
  return x > 1.0 ? log(1.0 + x) : logOfRatio(x / (2.0 + x));
}

float logCurve(float r, float b) {
  return logOnePlus(b * r) / logOnePlus(b);
}

float mapped(float x, float low, float high) {
  return x * (high - low) + low;
}

float fogLinear(float z, float start, float end) {
  if (!(end > start))
    return z < start ? 1.0 : 0.0;
  return clamp((end - z) / (end - start), 0.0, 1.0);
}

float fogExp(float z, float start, float density) {
  return exp2(-log2OfE * density * max(0.0, z - start));
}

float fogExp2(float z, float start, float density) {
  float x = density * max(0.0, z - start);
  return exp2(-log2OfE * x * x);
}
