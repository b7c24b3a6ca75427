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

/// Means over a stretch of scalars: extinction over the unit distance, and colour weighted by it.
struct Mean {
  V3 color;
  VF extinction;
};

/// A transfer function, several scalars at a time: from a few segments that registers hold, otherwise from
/// its table.
class Function {
public:
  /// `few` may be null.
  Function(const PiecewiseTable& table, const FewSegments* few)
      : m_table(table), m_occupancy(reinterpret_cast<const float*>(table.occupancy.data())),
        m_few(hn::MaxLanes(floats) == FewSegments::perRegister && few && few->count > 0 ? few : nullptr) {}

  /// The opacity over the unit distance, and which of the `wanted` scalars may have one at all; anything
  /// where none has.
  HWY_INLINE Mask opacityWhereSeen(VF x, Mask wanted, VF& opacity) const {
    if (m_few) {
      opacity = opacityAt(x, wanted);
      return hn::And(wanted, hn::Gt(opacity, hn::Zero(floats)));
    }
    // The largest opacity of a bin and the visible bins before it stand side by side.
    const VF largest = hn::GatherIndex(floats, m_occupancy, hn::ShiftLeft<1>(binOf(x)));
    const Mask seen = hn::And(wanted, hn::Gt(largest, hn::Zero(floats)));
    opacity = hn::AllFalse(floats, seen) ? hn::Zero(floats) : opacityAt(x, seen);
    return seen;
  }

  /// The colour where `wanted`; anything elsewhere.
  HWY_NOINLINE V3 colorAt(VF x, Mask wanted) const {
    V3 color;
    if (m_few) {
      const VI segment = fewAt(x);
      const VF within = hn::Sub(x, picked(m_few->starts, segment));
      color.x = hn::MulAdd(within, picked(m_few->slopes[0], segment), picked(m_few->values[0], segment));
      color.y = hn::MulAdd(within, picked(m_few->slopes[1], segment), picked(m_few->values[1], segment));
      color.z = hn::MulAdd(within, picked(m_few->slopes[2], segment), picked(m_few->values[2], segment));
      return clamped(color, 0.0f, 1.0f);
    }
    const Stretch stretch = stretchOf(x, wanted);
    const glm::vec4* texels = stretch.texels;
    VF start = all(texels[2].x);
    V3 value{all(texels[0].r), all(texels[0].g), all(texels[0].b)};
    V3 slope{all(texels[1].r), all(texels[1].g), all(texels[1].b)};
    while (stretch.high >= texels[2].y) {
      texels += 4;
      const Mask isHere = hn::Ge(x, all(texels[2].x));
      start = hn::IfThenElse(isHere, all(texels[2].x), start);
      value = chosen(isHere, {all(texels[0].r), all(texels[0].g), all(texels[0].b)}, value);
      slope = chosen(isHere, {all(texels[1].r), all(texels[1].g), all(texels[1].b)}, slope);
    }
    const VF within = hn::Sub(x, start);
    color.x = hn::MulAdd(within, slope.x, value.x);
    color.y = hn::MulAdd(within, slope.y, value.y);
    color.z = hn::MulAdd(within, slope.z, value.z);
    return clamped(color, 0.0f, 1.0f);
  }

  /// The opacity over the unit distance where `wanted`; anything elsewhere.
  HWY_INLINE VF opacityAt(VF x, Mask wanted) const {
    if (!m_few)
      return opacityOfMany(x, wanted);
    const VI segment = fewAt(x);
    const VF within = hn::Sub(x, picked(m_few->starts, segment));
    return hn::MulAdd(within, picked(m_few->slopes[3], segment), picked(m_few->values[3], segment));
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

  /// The segment that holds a scalar.
  HWY_INLINE std::size_t segmentOf(float x) const {
    const float place = (x - m_table.domain.x) * m_table.domain.y;
    const float bin = std::min(std::max(place, 0.0f), m_table.domain.z);
    std::size_t segment = static_cast<std::size_t>(m_table.bins[static_cast<std::size_t>(bin)].w);
    while (x >= m_table.segments[4 * segment + 2].y)
      ++segment;
    return segment;
  }

  /// The segments that hold some scalars.
  HWY_NOINLINE VI segmentsOf(VF x) const {
    if (m_few)
      return fewAt(x);
    VI segment =
        hn::ConvertTo(ints, hn::GatherIndex(floats, &m_table.bins.data()->w, hn::ShiftLeft<2>(binOf(x))));
    while (true) {
      const Mask isBehind = hn::Ge(x, endOf(segment));
      if (hn::AllFalse(floats, isBehind))
        return segment;
      segment = hn::Sub(segment, hn::VecFromMask(ints, hn::RebindMask(ints, isBehind)));
    }
  }

  /// Where some segments begin and end; colour and opacity (channel 3) at their start, and what those gain.
  HWY_INLINE VF startOf(VI segment) const {
    return m_few ? picked(m_few->starts, segment) : listed<8>(segment);
  }
  HWY_INLINE VF endOf(VI segment) const { return m_few ? picked(m_few->ends, segment) : listed<9>(segment); }
  template <int channel>
  HWY_INLINE VF valueOf(VI segment) const {
    return m_few ? picked(m_few->values[channel], segment) : listed<channel>(segment);
  }
  template <int channel>
  HWY_INLINE VF slopeOf(VI segment) const {
    return m_few ? picked(m_few->slopes[channel], segment) : listed<4 + channel>(segment);
  }

private:
  // A number of each segment among the sixteen of its texels.
  template <int place>
  HWY_INLINE VF listed(VI segment) const {
    return hn::GatherIndex(floats, &m_table.segments.data()->x + place, hn::ShiftLeft<4>(segment));
  }

  // The segments of a run of samples are few among many: each is read once for all of them.
  struct Stretch {
    const glm::vec4* texels; ///< of the first of them
    float high;              ///< the last scalar
  };

  HWY_INLINE Stretch stretchOf(VF x, Mask wanted) const {
    const float low = hn::GetLane(hn::MinOfLanes(floats, hn::IfThenElse(wanted, x, all(1e38f))));
    const float high = hn::GetLane(hn::MaxOfLanes(floats, hn::IfThenElse(wanted, x, all(-1e38f))));
    return {&m_table.segments[4 * segmentOf(low)], high};
  }

  HWY_NOINLINE VF opacityOfMany(VF x, Mask wanted) const {
    const Stretch stretch = stretchOf(x, wanted);
    const glm::vec4* texels = stretch.texels;
    VF start = all(texels[2].x), opacity = all(texels[0].a), slope = all(texels[1].a);
    while (stretch.high >= texels[2].y) {
      texels += 4;
      const Mask isHere = hn::Ge(x, all(texels[2].x));
      start = hn::IfThenElse(isHere, all(texels[2].x), start);
      opacity = hn::IfThenElse(isHere, all(texels[0].a), opacity);
      slope = hn::IfThenElse(isHere, all(texels[1].a), slope);
    }
    return hn::MulAdd(hn::Sub(x, start), slope, opacity);
  }

  // The segment of each scalar.
  HWY_INLINE VI fewAt(VF x) const {
    VI segment = hn::Zero(ints);
    for (int i = 0; i + 1 < m_few->count; ++i) {
      const auto isBehind = hn::RebindMask(ints, hn::Ge(x, all(m_few->ends[i])));
      segment = hn::Sub(segment, hn::VecFromMask(ints, isBehind));
    }
    return segment;
  }

  // The number of each segment in a column.
  HWY_INLINE VF picked(const float* column, VI segment) const {
    const auto within =
        hn::IndicesFromVec(floats, hn::And(segment, hn::Set(ints, FewSegments::perRegister - 1)));
    const VF lower = hn::TableLookupLanes(hn::Load(floats, column), within);
    if (m_few->count <= FewSegments::perRegister)
      return lower;
    const VF upper = hn::TableLookupLanes(hn::Load(floats, column + FewSegments::perRegister), within);
    const auto isUpper = hn::RebindMask(floats, hn::Gt(segment, hn::Set(ints, FewSegments::perRegister - 1)));
    return hn::IfThenElse(isUpper, upper, lower);
  }

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

  const PiecewiseTable& m_table;
  const float* m_occupancy;
  const FewSegments* m_few; // null: look them up in the table
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
