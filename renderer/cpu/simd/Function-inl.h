// SPDX-License-Identifier: GPL-3.0-or-later
// Piecewise linear functions of several samples at once, exact between knots (scene/function/PiecewiseTable).
#if defined(LIMN_CPU_FUNCTION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_FUNCTION_INL_H
#undef LIMN_CPU_FUNCTION_INL_H
#else
#define LIMN_CPU_FUNCTION_INL_H
#endif

#include "cpu/PictureTerms.h"
#include "cpu/simd/Math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// Colour and opacity over the unit distance.
struct Classified {
  V3 color;
  VF opacity;
};

class Function {
public:
  explicit Function(const PiecewiseTable& table)
      : m_table(table), m_occupancy(reinterpret_cast<const float*>(table.occupancy.data())) {}

  /// Which scalars may have an opacity at all.
  HWY_INLINE Mask mayBeSeen(VF x) const {
    const VF place = hn::Mul(hn::Sub(x, all(m_table.domain.x)), all(m_table.domain.y));
    const VI bin = hn::ConvertTo(ints, hn::Min(hn::Max(place, hn::Zero(floats)), all(m_table.domain.z)));
    // The largest opacity of a bin and the visible bins before it stand side by side.
    return hn::Gt(hn::GatherIndex(floats, m_occupancy, hn::ShiftLeft<1>(bin)), hn::Zero(floats));
  }

  /// The function where `wanted`; anything elsewhere. The segments of a run of samples are few: each is read
  /// once for all of them.
  HWY_INLINE Classified at(VF x, Mask wanted) const {
    const float low = hn::GetLane(hn::MinOfLanes(floats, hn::IfThenElse(wanted, x, all(3e38f))));
    const float high = hn::GetLane(hn::MaxOfLanes(floats, hn::IfThenElse(wanted, x, all(-3e38f))));
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

private:
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
