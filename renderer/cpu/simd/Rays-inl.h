// SPDX-License-Identifier: GPL-3.0-or-later
// The rays of neighbouring pixels, set up together: in double, as the reference does, so that both take the
// same samples (DEFINITION section 7).
#if defined(LIMN_CPU_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_RAYS_INL_H
#undef LIMN_CPU_RAYS_INL_H
#else
#define LIMN_CPU_RAYS_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Math-inl.h"
#include "scene/basics/StableMath.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

using Doubles = hn::CappedTag<double, 8>;
using VD = hn::Vec<Doubles>;
inline constexpr Doubles doubles;

HWY_INLINE VD allOf(double value) {
  return hn::Set(doubles, value);
}

/// Vectors of three in double, one for each of several rays.
struct D3 {
  VD x, y, z;
};

HWY_INLINE D3 allOf(const glm::dvec3& v) {
  return {allOf(v.x), allOf(v.y), allOf(v.z)};
}

/// `a + s b`, axis by axis.
HWY_INLINE D3 along(const D3& a, VD s, const D3& b) {
  return {hn::MulAdd(s, b.x, a.x), hn::MulAdd(s, b.y, a.y), hn::MulAdd(s, b.z, a.z)};
}

HWY_INLINE D3 scaled(const D3& v, VD by) {
  return {hn::Mul(v.x, by), hn::Mul(v.y, by), hn::Mul(v.z, by)};
}

HWY_INLINE D3 scaled(const D3& v, const D3& by) {
  return {hn::Mul(v.x, by.x), hn::Mul(v.y, by.y), hn::Mul(v.z, by.z)};
}

/// The parts of some rays in a box, mm; empty unless end > begin.
struct Spans {
  VD begin, end;
};

/// One number of each ray.
template <class T>
struct PerRay {
  HWY_ALIGN T of[HWY_MAX_BYTES / 4];
};

/// The rays of as many neighbouring pixels of a row as registers hold floats. Field by field what Ray is for
/// one.
class Rays {
public:
  /// The rays of pixels `x` … `x + lanes() - 1`. Those behind `toX` and those that miss what shows have no
  /// samples. Rays end at most `mostMm` behind their eyes' anchor (scene/steps/RayFrame).
  HWY_NOINLINE Rays(const PictureTerms& terms, int x, int toX, int y, double mostMm = 1e300)
      : m_terms(terms), m_x(x), m_y(y), m_mostMm(mostMm) {
    for (int part = 0; part < lanes(); part += atOnce())
      setUp(part);
    for (int lane = std::max(0, toX - x); lane < lanes(); ++lane) {
      to.of[lane] = from.of[lane];
      count.of[lane] = 0;
    }
  }

  bool hasSamples(int lane) const { return from.of[lane] < to.of[lane]; }

  /// Whether the ray meets what shows; the rest is unset of one that does not.
  bool isSeen(int lane) const { return count.of[lane] > 0; }

  Ray ray(int lane) const {
    Ray ray;
    ray.pixel = {m_x + lane, m_y};
    ray.count = count.of[lane];
    ray.from = from.of[lane];
    ray.to = to.of[lane];
    ray.ownFrom = ownFrom.of[lane];
    ray.ownTo = ownTo.of[lane];
    ray.offset = offset.of[lane];
    for (int axis = 0; axis < 3; ++axis) {
      ray.first[axis] = first[axis].of[lane];
      ray.stride[axis] = stride[axis].of[lane];
      ray.firstIndex[axis] = firstIndex[axis].of[lane];
      ray.toViewer[axis] = toViewer[axis].of[lane];
      ray.toLight[axis] = toLight[axis].of[lane];
      ray.halfway[axis] = halfway[axis].of[lane];
    }
    ray.firstDepth = firstDepth.of[lane];
    ray.strideDepth = strideDepth.of[lane];
    ray.units = units.of[lane];
    ray.span = {begin.of[lane], end.of[lane]};
    return ray;
  }

  PerRay<std::int32_t> count, from, to, ownFrom, ownTo;
  PerRay<float> offset, first[3], stride[3], firstIndex[3], firstDepth, strideDepth, units;
  PerRay<float> toViewer[3], toLight[3], halfway[3];
  PerRay<double> begin, end;

private:
  HWY_INLINE static int atOnce() { return static_cast<int>(hn::Lanes(doubles)); }

  HWY_INLINE static void keep(VD values, int part, PerRay<float>& kept) {
    hn::Store(hn::DemoteTo(hn::Rebind<float, Doubles>(), values), hn::Rebind<float, Doubles>(),
              kept.of + part);
  }

  HWY_INLINE static void keep(const D3& values, int part, PerRay<float> kept[3]) {
    keep(values.x, part, kept[0]);
    keep(values.y, part, kept[1]);
    keep(values.z, part, kept[2]);
  }

  // Whole numbers that an int holds.
  HWY_INLINE static void keep(VD values, int part, PerRay<std::int32_t>& kept) {
    hn::Store(hn::DemoteTo(hn::Rebind<std::int32_t, Doubles>(), values), hn::Rebind<std::int32_t, Doubles>(),
              kept.of + part);
  }

  HWY_INLINE static VD limited(VD value, VD least, VD most) { return hn::Min(hn::Max(value, least), most); }

  HWY_INLINE static void cut(VD p, VD d, double lower, double upper, Spans& span) {
    const hn::Mask<Doubles> isStill = hn::Lt(hn::Abs(d), allOf(1e-20));
    const hn::Mask<Doubles> isInside = hn::And(hn::Ge(p, allOf(lower)), hn::Lt(p, allOf(upper)));
    const VD perLength = hn::Div(allOf(1.0), hn::IfThenElse(isStill, allOf(1.0), d));
    const VD a = hn::Mul(hn::Sub(allOf(lower), p), perLength);
    const VD b = hn::Mul(hn::Sub(allOf(upper), p), perLength);
    const VD ofStill = hn::IfThenElse(isInside, span.end, allOf(-1e300));
    span.begin = hn::IfThenElse(isStill, span.begin, hn::Max(span.begin, hn::Min(a, b)));
    span.end = hn::IfThenElse(isStill, ofStill, hn::Min(span.end, hn::Max(a, b)));
  }

  HWY_INLINE Spans spansIn(const D3& anchor, const D3& direction, VD eye, const IndexBox& box) const {
    Spans span{eye, allOf(m_mostMm)};
    cut(anchor.x, direction.x, box.lower.x, box.upper.x, span);
    cut(anchor.y, direction.y, box.lower.y, box.upper.y, span);
    cut(anchor.z, direction.z, box.lower.z, box.upper.z, span);
    return span;
  }

  HWY_INLINE static VD affine(double a, VD x, double b, double c) {
    return hn::Add(hn::Add(allOf(a), hn::Mul(x, allOf(b))), allOf(c));
  }

  // a + x b + c
  HWY_INLINE static D3 affine(const glm::dvec3& a, VD x, const glm::dvec3& b, const glm::dvec3& c) {
    return {affine(a.x, x, b.x, c.x), affine(a.y, x, b.y, c.y), affine(a.z, x, b.z, c.z)};
  }

  // Rays `part` … `part + atOnce() - 1` of these.
  HWY_INLINE void setUp(int part) {
    const RayFrame& frame = m_terms.frame;
    // In the order of framedRay() and without joined multiply-adds: a ray in a face is inside or outside by
    // its last bit.
    const VD cx =
        hn::Add(hn::Iota(doubles, static_cast<double>(m_x + part)), allOf(0.5 - m_terms.size.x / 2.0));
    const double cy = m_terms.size.y / 2.0 - (m_y + 0.5);
    const VD tangent = allOf(frame.tangentPerPixel);
    const VD squares = hn::Add(hn::Mul(cx, cx), allOf(cy * cy));
    const VD length = hn::Sqrt(hn::Add(allOf(1.0), hn::Mul(hn::Mul(squares, tangent), tangent)));
    const D3 anchor = affine(frame.anchor, cx, frame.anchorX, cy * frame.anchorY);
    const D3 direction = scaled(affine(frame.direction, cx, frame.directionX, cy * frame.directionY),
                                hn::Div(allOf(1.0), length));
    const VD eye = hn::Mul(allOf(-frame.anchorDistanceMm), length);
    const Spans visible = spansIn(anchor, direction, eye, m_terms.visibleBox);
    Spans span = spansIn(anchor, direction, eye, m_terms.box);
    const hn::Mask<Doubles> isSeen =
        hn::And(hn::Gt(visible.end, visible.begin), hn::Gt(span.end, span.begin));
    if (hn::AllFalse(doubles, isSeen)) {
      for (int lane = part; lane < part + atOnce(); ++lane)
        count.of[lane] = from.of[lane] = to.of[lane] = 0;
      return;
    }
    span.begin = hn::IfThenElse(isSeen, span.begin, hn::Zero(doubles));
    span.end = hn::IfThenElse(isSeen, span.end, allOf(m_terms.lengthMm));
    divide(part, anchor, direction, eye, span, visible, isSeen);
    if (m_terms.effects.has(Effect::lighting))
      light(part, direction);
  }

  HWY_INLINE void divide(int part, const D3& anchor, const D3& direction, VD eye, const Spans& span,
                         const Spans& visible, hn::Mask<Doubles> isSeen) {
    const VD one = allOf(1.0);
    const VD length = hn::Sub(span.end, span.begin);
    const VD wanted =
        hn::Ceil(hn::Mul(length, allOf((1.0 - stepCountGuard) / (m_terms.stepLengths * m_terms.lengthMm))));
    const VD samples = limited(wanted, one, allOf(double(m_terms.mostSamples)));
    const VD stepMm = hn::Div(length, samples);
    HWY_ALIGN double offsets[HWY_MAX_BYTES / 4];
    for (int lane = 0; lane < atOnce(); ++lane)
      offsets[lane] =
          m_terms.effects.has(Effect::jitter) ? jitteredOffset(m_x + part + lane, m_y, m_terms.size.y) : 0.5;
    const VD before = hn::Load(doubles, offsets);
    const VD behindEntry = hn::Mul(before, stepMm);
    const D3 firstIndices = along(along(anchor, span.begin, direction), behindEntry, direction);
    keep(hn::IfThenElseZero(isSeen, samples), part, count);
    keep(before, part, offset);
    keep(firstIndices, part, firstIndex);
    keep(along(firstIndices, one, allOf(m_terms.centre)), part, first);
    keep(scaled(direction, stepMm), part, stride);
    const VD perLength = allOf(1.0 / m_terms.lengthMm);
    const VD beforeAnchor = hn::Neg(hn::Add(eye, allOf(m_terms.frame.anchorDistanceMm)));
    keep(hn::Mul(hn::Add(hn::Add(span.begin, behindEntry), beforeAnchor), perLength), part, firstDepth);
    keep(hn::Mul(stepMm, perLength), part, strideDepth);
    keep(hn::Mul(hn::Mul(stepMm, perLength), allOf(double(m_terms.perUnitDistance))), part, units);
    hn::Store(span.begin, doubles, begin.of + part);
    hn::Store(span.end, doubles, end.of + part);
    // The samples that lie in the part where something shows, one more on either side.
    const VD perStep = hn::Div(one, stepMm);
    const VD firstSeen =
        hn::Sub(hn::Floor(hn::MulSub(hn::Sub(visible.begin, span.begin), perStep, before)), one);
    const VD lastSeen = hn::Add(hn::Ceil(hn::MulSub(hn::Sub(visible.end, span.begin), perStep, before)), one);
    const Spans own = ownSamples(anchor, direction, span, perStep, before, samples);
    keep(own.begin, part, ownFrom);
    keep(own.end, part, ownTo);
    const VD fromSample = limited(firstSeen, own.begin, own.end);
    keep(fromSample, part, from);
    keep(hn::IfThenElse(isSeen, limited(lastSeen, fromSample, own.end), fromSample), part, to);
  }

  // The samples of [begin, end) lie in the brick. Each plane between bricks has a first sample behind it,
  // found from the plane and the ray alone and without joined multiply-adds: whoever draws the brick on its
  // other side, on whatever processor, finds the same.
  HWY_INLINE Spans ownSamples(const D3& anchor, const D3& direction, const Spans& span, VD perStep, VD before,
                              VD samples) const {
    Spans own{hn::Zero(doubles), samples};
    if (!m_terms.brick)
      return own;
    const glm::dvec3& lower = m_terms.brick->lower;
    const glm::dvec3& upper = m_terms.brick->upper;
    const VD origins[3] = {anchor.x, anchor.y, anchor.z};
    const VD directions[3] = {direction.x, direction.y, direction.z};
    for (int axis = 0; axis < 3; ++axis) {
      const VD p = origins[axis];
      const VD d = directions[axis];
      const hn::Mask<Doubles> isStill = hn::Lt(hn::Abs(d), allOf(1e-20));
      const VD perLength = hn::Div(allOf(1.0), hn::IfThenElse(isStill, allOf(1.0), d));
      const VD a = firstBehind(lower[axis], p, perLength, span, perStep, before, samples);
      const VD b = firstBehind(upper[axis], p, perLength, span, perStep, before, samples);
      const hn::Mask<Doubles> isInside =
          hn::And(hn::Ge(p, allOf(lower[axis])), hn::Lt(p, allOf(upper[axis])));
      const VD ofStill = hn::IfThenElseZero(isInside, own.end);
      own.begin = hn::IfThenElse(isStill, own.begin, hn::Max(own.begin, hn::Min(a, b)));
      own.end = hn::IfThenElse(isStill, ofStill, hn::Min(own.end, hn::Max(a, b)));
    }
    own.begin = hn::Min(own.begin, own.end);
    return own;
  }

  HWY_INLINE static VD firstBehind(double plane, VD p, VD perLength, const Spans& span, VD perStep, VD before,
                                   VD samples) {
    const VD at = hn::Mul(hn::Sub(allOf(plane), p), perLength);
    const VD sample = hn::Ceil(hn::Sub(hn::Mul(hn::Sub(at, span.begin), perStep), before));
    return limited(sample, hn::Zero(doubles), samples);
  }

  HWY_INLINE void light(int part, const D3& direction) {
    const D3 forward = scaled(direction, allOf(m_terms.spacing * m_terms.lengthMm));
    const D3 viewer{hn::Neg(forward.x), hn::Neg(forward.y), hn::Neg(forward.z)};
    D3 towards = viewer;
    D3 middle = viewer;
    if (m_terms.effects.has(Effect::fixedLight)) {
      towards = allOf(m_terms.towardsLight);
      middle = along(viewer, allOf(1.0), towards);
      const VD length = hn::Sqrt(
          hn::MulAdd(middle.x, middle.x, hn::MulAdd(middle.y, middle.y, hn::Mul(middle.z, middle.z))));
      const hn::Mask<Doubles> isLong = hn::Gt(length, allOf(shortestHalfVector));
      middle =
          scaled(middle,
                 hn::IfThenElseZero(isLong, hn::Div(allOf(1.0), hn::IfThenElse(isLong, length, allOf(1.0)))));
    }
    keep(viewer, part, toViewer);
    keep(towards, part, toLight);
    keep(middle, part, halfway);
  }

  const PictureTerms& m_terms;
  int m_x, m_y;
  double m_mostMm;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
