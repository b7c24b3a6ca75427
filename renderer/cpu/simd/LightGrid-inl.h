// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of light to places, read from the nodes of a grid (scene/light/LightGrid.h).
#if defined(LIMN_CPU_LIGHT_GRID_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_LIGHT_GRID_INL_H
#undef LIMN_CPU_LIGHT_GRID_INL_H
#else
#define LIMN_CPU_LIGHT_GRID_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Math-inl.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// M of DEFINITION section 11 at several places, trilinear between the eight nodes around each.
class GridLight {
public:
  HWY_INLINE GridLight(const TravelTerms& travel, const V3& index) : m_travel(travel) {
    const VI x = lowOf(index.x, 0, m_weight.x), y = lowOf(index.y, 1, m_weight.y),
             z = lowOf(index.z, 2, m_weight.z);
    const VI row = hn::Add(hn::Mul(z, hn::Set(ints, travel.found.nodes.count.y)), y);
    hn::Store(hn::Add(hn::Mul(row, hn::Set(ints, travel.found.nodes.count.x)), x), ints, m_low);
  }

  /// Of a light that has a direction.
  HWY_INLINE VF direct() const {
    VF sum = hn::Zero(floats);
    for (int row = 0; row < 4; ++row) {
      // Neighbours along x are read together.
      HWY_ALIGN std::uint32_t pairs[most];
      const std::uint8_t* nodes = m_travel.found.direct->data() + stepTo(2 * row);
      for (int lane = 0; lane < lanes(); ++lane) {
        std::uint16_t pair = 0;
        std::memcpy(&pair, nodes + m_low[lane], 2);
        pairs[lane] = pair;
      }
      const VW word = hn::Load(words, pairs);
      const VF lower = numberOf(hn::And(word, hn::Set(words, 255))),
               upper = numberOf(hn::ShiftRight<8>(word));
      sum = hn::MulAdd(shareOf(row), hn::MulAdd(m_weight.x, hn::Sub(upper, lower), lower), sum);
    }
    return hn::Mul(hn::Sub(sum, all(1.0f)), all(1.0f / 254.0f));
  }

  /// Of ambient light, around normals of unit length, or zero.
  HWY_INLINE VF ambient(const V3& normal) const {
    // The shares of the axes are nothing without a normal: they are added as they are mixed.
    const VF perCode = all(1.0f / 254.0f);
    const V3 along{hn::Mul(normal.x, perCode), hn::Mul(normal.y, perCode), hn::Mul(normal.z, perCode)};
    const VF middle = hn::MulAdd(hn::Add(hn::Add(along.x, along.y), along.z), all(127.0f), perCode);
    VF sum = hn::Zero(floats);
    for (int row = 0; row < 4; ++row) {
      HWY_ALIGN std::uint32_t pairs[2 * most];
      const std::array<std::uint8_t, 4>* nodes = m_travel.found.ambient->data() + stepTo(2 * row);
      for (int lane = 0; lane < lanes(); ++lane)
        std::memcpy(&pairs[2 * lane], nodes + m_low[lane], 8);
      VW lower, upper;
      hn::LoadInterleaved2(words, pairs, lower, upper);
      const VF first = around(lower, perCode, along);
      const VF second = around(upper, perCode, along);
      sum = hn::MulAdd(shareOf(row), hn::MulAdd(m_weight.x, hn::Sub(second, first), first), sum);
    }
    return clamped(hn::Sub(sum, middle), 0.0f, 1.0f);
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;

  HWY_INLINE VI lowOf(VF index, int axis, VF& weight) const {
    const auto last = static_cast<float>(m_travel.found.nodes.count[axis] - 1);
    const VF place =
        clamped(hn::MulAdd(index, all(m_travel.perIndex[axis]), all(m_travel.shift[axis])), 0.0f, last);
    const VF low = hn::Min(hn::Floor(place), all(last - 1.0f));
    weight = hn::Sub(place, low);
    return intOf(low);
  }

  // From the node of the smallest indices.
  HWY_INLINE std::ptrdiff_t stepTo(int corner) const {
    const std::ptrdiff_t row = m_travel.found.nodes.count.x;
    return (corner & 1) + (corner >> 1 & 1) * row + (corner >> 2) * row * m_travel.found.nodes.count.y;
  }

  // Of two neighbours along x.
  HWY_INLINE VF shareOf(int row) const {
    const VF y = (row & 1) != 0 ? m_weight.y : hn::Sub(all(1.0f), m_weight.y);
    const VF z = (row & 2) != 0 ? m_weight.z : hn::Sub(all(1.0f), m_weight.z);
    return hn::Mul(y, z);
  }

  // What nodes say of normals, but for the codes' middles.
  HWY_INLINE static VF around(VW codes, VF perCode, const V3& along) {
    const VW byte = hn::Set(words, 255);
    const VF x = hn::Mul(along.x, numberOf(hn::And(hn::ShiftRight<8>(codes), byte)));
    const VF xy = hn::MulAdd(along.y, numberOf(hn::And(hn::ShiftRight<16>(codes), byte)), x);
    const VF xyz = hn::MulAdd(along.z, numberOf(hn::ShiftRight<24>(codes)), xy);
    return hn::MulAdd(perCode, numberOf(hn::And(codes, byte)), xyz);
  }

  HWY_INLINE static VF numberOf(VW byte) { return hn::ConvertTo(floats, hn::BitCast(ints, byte)); }

  const TravelTerms& m_travel;
  V3 m_weight;
  HWY_ALIGN std::int32_t m_low[most]; // the node of smallest indices around each place
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
