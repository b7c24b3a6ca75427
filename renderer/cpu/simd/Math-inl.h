// SPDX-License-Identifier: GPL-3.0-or-later
// Twins of renderer/scene/basics/StableMath.h in float vectors, under the same names. Compiled once for each
// instruction set (Highway): no ordinary include guard.
#if defined(LIMN_CPU_MATH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_MATH_INL_H
#undef LIMN_CPU_MATH_INL_H
#else
#define LIMN_CPU_MATH_INL_H
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// More than eight in a row run out of a block, and gain nothing.
using Floats = hn::CappedTag<float, 8>;
using Ints = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using VF = hn::Vec<Floats>;
using VI = hn::Vec<Ints>;
using VW = hn::Vec<Words>;
using Mask = hn::Mask<Floats>;

inline constexpr Floats floats;
inline constexpr Ints ints;
inline constexpr Words words;

/// The number of samples that are computed together.
HWY_INLINE int lanes() {
  return static_cast<int>(hn::Lanes(floats));
}

HWY_INLINE VF all(float value) {
  return hn::Set(floats, value);
}

/// Three numbers of each sample.
struct V3 {
  VF x, y, z;
};

HWY_INLINE V3 all(const glm::vec3& v) {
  return {all(v.x), all(v.y), all(v.z)};
}

HWY_INLINE V3 zero() {
  return {hn::Zero(floats), hn::Zero(floats), hn::Zero(floats)};
}

HWY_INLINE VF mix(VF a, VF b, VF w) {
  return hn::MulAdd(w, hn::Sub(b, a), a);
}

HWY_INLINE VF dot(const V3& a, const V3& b) {
  return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

HWY_INLINE V3 scaled(const V3& v, VF by) {
  return {hn::Mul(v.x, by), hn::Mul(v.y, by), hn::Mul(v.z, by)};
}

HWY_INLINE VF clamped(VF v, float low, float high) {
  return hn::Min(hn::Max(v, all(low)), all(high));
}

HWY_INLINE V3 clamped(const V3& v, float low, float high) {
  return {clamped(v.x, low, high), clamped(v.y, low, high), clamped(v.z, low, high)};
}

HWY_INLINE V3 chosen(Mask mask, const V3& yes, const V3& no) {
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y),
          hn::IfThenElse(mask, yes.z, no.z)};
}

/// The lanes of a mask as bits, the first lowest.
HWY_INLINE std::uint32_t bitsOf(Mask mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(floats, mask, bytes);
  return bytes[0] | std::uint32_t{bytes[1]} << 8;
}

/// Whole numbers of 0 … 2^22 as ints: behind 2^23 they stand in the lowest bits. Cheaper than a conversion,
/// which has to care for numbers that no int holds.
HWY_INLINE VI intOf(VF whole) {
  return hn::Sub(hn::BitCast(ints, hn::Add(whole, all(8388608.0f))), hn::Set(ints, 0x4B000000));
}

/// 2^n for whole n of -126 … 127.
HWY_INLINE VF powerOfTwo(VF n) {
  return hn::BitCast(floats, hn::ShiftLeft<23>(hn::BitCast(ints, hn::Add(n, all(8388608.0f + 127.0f)))));
}

/// a + b x
HWY_INLINE VF line(VF x, float a, float b) {
  return hn::MulAdd(x, all(b), all(a));
}

/// The polynomial of coefficients c0 … c5, in pairs: each waits for fewer others than one after the other.
HWY_INLINE VF quintic(VF x, float c0, float c1, float c2, float c3, float c4, float c5) {
  const VF square = hn::Mul(x, x);
  return hn::MulAdd(square, hn::MulAdd(square, line(x, c4, c5), line(x, c2, c3)), line(x, c0, c1));
}

/// 1 - exp(-x) for x >= 0, to the last bits relative to itself: (1 - s) - s (exp(r) - 1) for s = 2^-n and
/// |r| <= ln 2 / 2. The coefficients interpolate (exp(r) - 1)/r in Chebyshev points: 1.2e-8.
HWY_INLINE VF oneMinusExpNeg(VF x) {
  const VF limited = hn::Min(x, all(87.0f));
  const VF n = hn::Round(hn::Mul(limited, all(1.44269504f)));
  // ln 2 in two parts, of which n times the first is exact.
  const VF r = hn::MulSub(n, all(1.42860677e-6f), hn::NegMulAdd(n, all(0.693145752f), limited));
  const VF series = quintic(r, 1.0f, 0.5f, 0.166665052f, 0.0416664649f, 0.00836915567f, 0.00139336500f);
  const VF s = powerOfTwo(hn::Neg(n));
  return hn::NegMulAdd(hn::Mul(s, r), series, hn::Sub(all(1.0f), s));
}

/// A positive number as 2^exponent (1 + fraction), fraction from sqrt(1/2) - 1 to sqrt(2) - 1.
struct Parts {
  VF exponent, fraction;
};

HWY_INLINE Parts partsOf(VF x) {
  const VI bits = hn::BitCast(ints, x);
  const VI above = hn::Sub(bits, hn::Set(ints, 0x3f3504f3)); // sqrt(1/2)
  const VI exponent = hn::ShiftRight<23>(above);
  const VF scaledDown = hn::BitCast(floats, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
  return {hn::ConvertTo(floats, exponent), hn::Sub(scaledDown, all(1.0f))};
}

/// log(1 + t)/t for t from sqrt(1/2) - 1 to sqrt(2) - 1, interpolated in Chebyshev points: 3e-8.
HWY_INLINE VF logSeries(VF t) {
  const VF square = hn::Mul(t, t);
  const VF fourth = hn::Mul(square, square);
  const VF low = hn::MulAdd(square, line(t, 0.333341933f, -0.250013522f), line(t, 1.0f, -0.499999964f));
  const VF high =
      hn::MulAdd(square, line(t, 0.149774013f, -0.142692582f), line(t, 0.199559334f, -0.165779929f));
  return hn::MulAdd(fourth, hn::MulAdd(fourth, all(0.0853331308f), high), low);
}

/// -log(1 - a) for opacities, to the last bits relative to itself.
HWY_INLINE VF minusLog1mOpacity(VF a) {
  constexpr float largest = 1.0f - 1.0f / 16777216.0f;
  const VF opacity = clamped(a, 0.0f, largest);
  const Parts parts = partsOf(hn::Sub(all(1.0f), opacity));
  // Where 1 - a has lost digits of a, the fraction is -a itself.
  const VF t = hn::IfThenElse(hn::Eq(parts.exponent, hn::Zero(floats)), hn::Neg(opacity), parts.fraction);
  return hn::Neg(hn::MulAdd(parts.exponent, all(0.693147181f), hn::Mul(t, logSeries(t))));
}

/// -integral of log(1 - x s) over s in 0..1, for 0 <= x <= largestOpacity.
inline HWY_NOINLINE VF meanMinusLog1m(VF x) {
  const Mask isSmall = hn::Lt(x, all(0.25f));
  VF series = all(1.0f / 110.0f);
  for (const float next : {90.0f, 72.0f, 56.0f, 42.0f, 30.0f, 20.0f, 12.0f, 6.0f, 2.0f})
    series = hn::MulAdd(x, series, all(1.0f / next));
  const VF safe = hn::IfThenElse(isSmall, all(1.0f), x);
  const VF rest = hn::Mul(hn::Sub(all(1.0f), x), hn::Div(minusLog1mOpacity(x), safe));
  return hn::IfThenElse(isSmall, hn::Mul(x, series), hn::Sub(all(1.0f), rest));
}

/// -integral of s log(1 - x s) over s in 0..1, for 0 <= x <= largestOpacity.
inline HWY_NOINLINE VF momentMinusLog1m(VF x) {
  const Mask isSmall = hn::Lt(x, all(0.25f));
  VF series = all(1.0f / 120.0f);
  for (const float next : {99.0f, 80.0f, 63.0f, 48.0f, 35.0f, 24.0f, 15.0f, 8.0f, 3.0f})
    series = hn::MulAdd(x, series, all(1.0f / next));
  const VF safe = hn::IfThenElse(isSmall, all(1.0f), x);
  const VF squares = hn::Mul(hn::Sub(all(1.0f), x), hn::Add(all(1.0f), x));
  const VF rest = hn::Mul(squares, hn::Div(minusLog1mOpacity(x), hn::Add(safe, safe)));
  const VF closed = hn::Div(hn::Sub(hn::MulAdd(all(0.25f), x, all(0.5f)), rest), safe);
  return hn::IfThenElse(isSmall, hn::Mul(x, series), closed);
}

inline HWY_NOINLINE VF expNeg(VF x) {
  return hn::Exp(floats, hn::Neg(x));
}

/// base^exponent for bases above 0 and at most 1; 0 elsewhere, and where it is below 2^-126. The coefficients
/// interpolate 2^f for |f| <= 1/2 in Chebyshev points: 1e-7.
HWY_INLINE VF powerOrZero(VF base, VF exponent) {
  const Mask isPositive = hn::Gt(base, hn::Zero(floats));
  const Parts parts = partsOf(hn::IfThenElse(isPositive, base, all(1.0f)));
  const VF ofFraction = hn::Mul(hn::Mul(parts.fraction, all(1.44269504f)), logSeries(parts.fraction));
  const VF power = hn::Mul(exponent, hn::Add(parts.exponent, ofFraction));
  const VF limited = hn::Max(power, all(-126.0f));
  const VF n = hn::Round(limited);
  const VF f = hn::Sub(limited, n);
  const VF series =
      quintic(f, 1.0f, 0.693147188f, 0.240221075f, 0.0555035711f, 0.00967603192f, 0.00133908637f);
  return hn::IfThenElseZero(hn::And(isPositive, hn::Ge(power, all(-126.0f))), hn::Mul(series, powerOfTwo(n)));
}

HWY_INLINE VF blinnTerm(VF cosine, VF exponent) {
  return powerOrZero(hn::Min(cosine, all(1.0f)), exponent);
}

HWY_INLINE V3 knee(const V3& color, float k) {
  const VF largest = hn::Max(hn::Max(color.x, color.y), color.z);
  const Mask isAbove = hn::Gt(largest, all(k));
  const float d = 1.0f - k;
  const VF safe = hn::IfThenElse(isAbove, largest, all(1.0f));
  const VF kneed = hn::Sub(all(1.0f), hn::Div(all(d * d), hn::Add(safe, all(1.0f - 2.0f * k))));
  return scaled(color, hn::IfThenElse(isAbove, hn::Div(kneed, safe), all(1.0f)));
}

HWY_INLINE VF energyFactor(VF exponent, float largestExponent) {
  return hn::Div(hn::Add(exponent, all(8.0f)), all(largestExponent + 8.0f));
}

HWY_INLINE VF significanceWeight(float low, float high, VF r) {
  if (!(high > low))
    return hn::IfThenElseZero(hn::Ge(r, all(high)), all(1.0f));
  const VF x = clamped(hn::Div(hn::Sub(r, all(low)), all(high - low)), 0.0f, 1.0f);
  return hn::Mul(hn::Mul(x, x), hn::NegMulAdd(all(2.0f), x, all(3.0f)));
}

HWY_INLINE VF logCurve(VF r, float b) {
  return hn::Mul(hn::Log1p(floats, hn::Mul(all(b), r)), all(static_cast<float>(1.0 / std::log1p(double(b)))));
}

HWY_INLINE VF mapped(VF x, float low, float high) {
  return hn::MulAdd(x, all(high - low), all(low));
}

HWY_INLINE VF fogLinear(VF z, float start, float end) {
  if (!(end > start))
    return hn::IfThenElseZero(hn::Lt(z, all(start)), all(1.0f));
  return clamped(hn::Div(hn::Sub(all(end), z), all(end - start)), 0.0f, 1.0f);
}

HWY_INLINE VF fogExp(VF z, float start, float density) {
  return expNeg(hn::Mul(all(density), hn::Max(hn::Sub(z, all(start)), hn::Zero(floats))));
}

HWY_INLINE VF fogExp2(VF z, float start, float density) {
  const VF x = hn::Mul(all(density), hn::Max(hn::Sub(z, all(start)), hn::Zero(floats)));
  return expNeg(hn::Min(hn::Mul(x, x), all(1e4f)));
}

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
