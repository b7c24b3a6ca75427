// SPDX-License-Identifier: GPL-3.0-or-later
// Piecewise linear functions of several samples at once, exact between knots (scene/function/PiecewiseTable).
#if defined(LIMN_CPU_FUNCTION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_FUNCTION_INL_H
#undef LIMN_CPU_FUNCTION_INL_H
#else
#define LIMN_CPU_FUNCTION_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// Colour and opacity over the unit distance.
struct Classified {
  V3 color;
  VF opacity;
};

/// Means over a stretch of scalars: extinction over the unit distance, and colour weighted by it.
struct Mean {
  V3 color;
  VF extinction;
};

class Function {
public:
  explicit Function(const PiecewiseTable& table)
      : m_table(table), m_occupancy(reinterpret_cast<const float*>(table.occupancy.data())) {}

  /// Which scalars may have an opacity at all.
  HWY_INLINE Mask mayBeSeen(VF x) const {
    // The largest opacity of a bin and the visible bins before it stand side by side.
    return hn::Gt(hn::GatherIndex(floats, m_occupancy, hn::ShiftLeft<1>(binOf(x))), hn::Zero(floats));
  }

  /// The function where `wanted`; anything elsewhere. The segments of a run of samples are few: each is read
  /// once for all of them.
  HWY_NOINLINE Classified at(VF x, Mask wanted) const {
    const float low = hn::GetLane(hn::MinOfLanes(floats, hn::IfThenElse(wanted, x, all(1e38f))));
    const float high = hn::GetLane(hn::MaxOfLanes(floats, hn::IfThenElse(wanted, x, all(-1e38f))));
    std::size_t segment = segmentOf(low);
    const glm::vec4* texels = &m_table.segments[4 * segment];
    VF start = all(texels[2].x);
    V3 value{all(texels[0].r), all(texels[0].g), all(texels[0].b)};
    V3 slope{all(texels[1].r), all(texels[1].g), all(texels[1].b)};
    VF opacity = all(texels[0].a);
    VF opacitySlope = all(texels[1].a);
    while (high >= texels[2].y) {
      texels += 4;
      const Mask isHere = hn::Ge(x, all(texels[2].x));
      start = hn::IfThenElse(isHere, all(texels[2].x), start);
      value = chosen(isHere, {all(texels[0].r), all(texels[0].g), all(texels[0].b)}, value);
      slope = chosen(isHere, {all(texels[1].r), all(texels[1].g), all(texels[1].b)}, slope);
      opacity = hn::IfThenElse(isHere, all(texels[0].a), opacity);
      opacitySlope = hn::IfThenElse(isHere, all(texels[1].a), opacitySlope);
    }
    const VF within = hn::Sub(x, start);
    Classified result;
    result.color = clamped({hn::MulAdd(within, slope.x, value.x), hn::MulAdd(within, slope.y, value.y),
                            hn::MulAdd(within, slope.z, value.z)},
                           0.0f, 1.0f);
    result.opacity = hn::MulAdd(within, opacitySlope, opacity);
    return result;
  }

  /// The opacity alone.
  HWY_NOINLINE VF opacityAt(VF x, Mask wanted) const {
    const float low = hn::GetLane(hn::MinOfLanes(floats, hn::IfThenElse(wanted, x, all(1e38f))));
    const float high = hn::GetLane(hn::MaxOfLanes(floats, hn::IfThenElse(wanted, x, all(-1e38f))));
    const glm::vec4* texels = &m_table.segments[4 * segmentOf(low)];
    VF start = all(texels[2].x), opacity = all(texels[0].a), slope = all(texels[1].a);
    while (high >= texels[2].y) {
      texels += 4;
      const Mask isHere = hn::Ge(x, all(texels[2].x));
      start = hn::IfThenElse(isHere, all(texels[2].x), start);
      opacity = hn::IfThenElse(isHere, all(texels[0].a), opacity);
      slope = hn::IfThenElse(isHere, all(texels[1].a), slope);
    }
    return hn::MulAdd(hn::Sub(x, start), slope, opacity);
  }

  /// Whether anything between two scalars may have an opacity.
  HWY_NOINLINE Mask mayBeSeenBetween(VF a, VF b) const {
    const VI low = hn::ShiftLeft<1>(binOf(hn::Min(a, b)));
    const VI high = hn::ShiftLeft<1>(binOf(hn::Max(a, b)));
    const VF before = hn::GatherIndex(floats, m_occupancy + 1, low);
    const VF own =
        hn::IfThenElseZero(hn::Gt(hn::GatherIndex(floats, m_occupancy, high), hn::Zero(floats)), all(1.0f));
    return hn::Gt(hn::Add(hn::GatherIndex(floats, m_occupancy + 1, high), own), before);
  }

  /// The mean extinction and the mean colour, weighted by extinction, between two scalars, where `wanted`
  /// (DEFINITION section 7): exact integrals over the segments, so they depend on no step.
  HWY_NOINLINE Mean meanBetween(VF a, VF b, Mask wanted) const {
    const VF from = hn::Min(a, b);
    const VF to = hn::Max(a, b);
    const float low = hn::GetLane(hn::MinOfLanes(floats, hn::IfThenElse(wanted, from, all(1e38f))));
    const float high = hn::GetLane(hn::MaxOfLanes(floats, hn::IfThenElse(wanted, to, all(-1e38f))));
    Mean sum{zero(), hn::Zero(floats)};
    const glm::vec4* texels = &m_table.segments[4 * segmentOf(low)];
    while (true) {
      // Segment 0 reaches down without end.
      const bool isFirst = texels == m_table.segments.data();
      const float start = texels[2].x, end = texels[2].y;
      const VF pieceFrom = isFirst ? from : hn::Max(from, all(start));
      const VF pieceTo = hn::Min(to, all(end));
      // Two scalars of one segment may be equal.
      const Mask isWhole = hn::And(hn::Ge(from, isFirst ? from : all(start)), hn::Lt(to, all(end)));
      const Mask isPart = hn::And(wanted, hn::Or(isWhole, hn::Gt(pieceTo, pieceFrom)));
      if (!hn::AllFalse(floats, isPart)) {
        const Mean mean = meanOfPiece(texels, pieceFrom, pieceTo);
        const VF share =
            hn::IfThenElse(isWhole, all(1.0f), hn::Div(hn::Sub(pieceTo, pieceFrom), hn::Sub(to, from)));
        const VF weight = hn::IfThenElseZero(isPart, share);
        sum.extinction = hn::MulAdd(weight, mean.extinction, sum.extinction);
        sum.color = {hn::MulAdd(weight, mean.color.x, sum.color.x),
                     hn::MulAdd(weight, mean.color.y, sum.color.y),
                     hn::MulAdd(weight, mean.color.z, sum.color.z)};
      }
      if (!(high >= end))
        break;
      texels += 4;
    }
    const Mask absorbs = hn::Gt(sum.extinction, hn::Zero(floats));
    const VF safe = hn::IfThenElse(absorbs, sum.extinction, all(1.0f));
    sum.color = clamped(scaled(sum.color, hn::IfThenElseZero(absorbs, hn::Div(all(1.0f), safe))), 0.0f, 1.0f);
    return sum;
  }

private:
  HWY_INLINE VI binOf(VF x) const {
    const VF place = hn::Mul(hn::Sub(x, all(m_table.domain.x)), all(m_table.domain.y));
    return hn::ConvertTo(ints, hn::Min(hn::Max(place, hn::Zero(floats)), all(m_table.domain.z)));
  }

  // The means of colour times extinction and of extinction between two scalars of one segment.
  HWY_INLINE static Mean meanOfPiece(const glm::vec4* texels, VF from, VF to) {
    constexpr float largest = 1.0f - 1.0f / 16777216.0f;
    const bool isRising = texels[1].a >= 0.0f;
    const VF faint = hn::Sub(isRising ? from : to, all(texels[2].x)); // the end of less opacity
    const VF dense = hn::Sub(isRising ? to : from, all(texels[2].x));
    const VF low = clamped(hn::MulAdd(faint, all(texels[1].a), all(texels[0].a)), 0.0f, largest);
    const VF high =
        hn::Max(clamped(hn::MulAdd(dense, all(texels[1].a), all(texels[0].a)), 0.0f, largest), low);
    const VF share = hn::Div(hn::Sub(high, low), hn::Sub(all(1.0f), low));
    const VF extinction = minusLog1mOpacity(low);
    const VF mean = hn::Add(extinction, meanMinusLog1m(share));
    const VF moment = hn::MulAdd(all(0.5f), extinction, momentMinusLog1m(share));
    const VF rest = hn::Sub(mean, moment);
    Mean result;
    result.extinction = mean;
    result.color.x = hn::MulAdd(colorAt(texels, 0, faint), rest, hn::Mul(colorAt(texels, 0, dense), moment));
    result.color.y = hn::MulAdd(colorAt(texels, 1, faint), rest, hn::Mul(colorAt(texels, 1, dense), moment));
    result.color.z = hn::MulAdd(colorAt(texels, 2, faint), rest, hn::Mul(colorAt(texels, 2, dense), moment));
    return result;
  }

  HWY_INLINE static VF colorAt(const glm::vec4* texels, int channel, VF within) {
    return clamped(hn::MulAdd(within, all(texels[1][channel]), all(texels[0][channel])), 0.0f, 1.0f);
  }

  HWY_INLINE std::size_t segmentOf(float x) const {
    const float place = (x - m_table.domain.x) * m_table.domain.y;
    const float bin = std::min(std::max(place, 0.0f), m_table.domain.z);
    std::size_t segment = static_cast<std::size_t>(m_table.bins[static_cast<std::size_t>(bin)].w);
    while (x >= m_table.segments[4 * segment + 2].y)
      ++segment;
    return segment;
  }

  const PiecewiseTable& m_table;
  const float* m_occupancy;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
