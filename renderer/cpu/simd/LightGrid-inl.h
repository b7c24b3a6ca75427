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

/// M of DEFINITION section 11 at several places: of the eight nodes around each those that know it, by their
/// trilinear shares.
class GridLight {
public:
  HWY_INLINE GridLight(const TravelTerms& travel, const V3& index) : m_travel(travel) {
    const VI x = lowOf(index.x, 0, m_weight.x), y = lowOf(index.y, 1, m_weight.y),
             z = lowOf(index.z, 2, m_weight.z);
    const VI row = hn::Add(hn::Mul(z, hn::Set(ints, travel.nodes.count.y)), y);
    hn::Store(hn::Add(hn::Mul(row, hn::Set(ints, travel.nodes.count.x)), x), ints, m_low);
  }

  /// Of a light that has a direction.
  HWY_INLINE VF direct() const {
    VF known = hn::Zero(floats), sum = hn::Zero(floats);
    for (int row = 0; row < 4; ++row) {
      // Neighbours along x are read together.
      HWY_ALIGN std::uint32_t pairs[most];
      const std::uint8_t* nodes = m_travel.direct->data() + stepTo(2 * row);
      for (int lane = 0; lane < lanes(); ++lane) {
        std::uint16_t pair = 0;
        std::memcpy(&pair, nodes + m_low[lane], 2);
        pairs[lane] = pair;
      }
      const VW word = hn::Load(words, pairs);
      add(numberOf(hn::And(word, hn::Set(words, 255))), shareOf(2 * row), known, sum);
      add(numberOf(hn::ShiftRight<8>(word)), shareOf(2 * row + 1), known, sum);
    }
    return mean(sum, known);
  }

  /// Of ambient light, around normals of unit length, or zero.
  HWY_INLINE VF ambient(const V3& normal) const {
    VF known = hn::Zero(floats), sum = hn::Zero(floats);
    V3 along = zero();
    const VW byte = hn::Set(words, 255);
    for (int corner = 0; corner < 8; ++corner) {
      HWY_ALIGN std::uint32_t codes[most];
      const std::array<std::uint8_t, 4>* nodes = m_travel.ambient->data() + stepTo(corner);
      for (int lane = 0; lane < lanes(); ++lane)
        std::memcpy(&codes[lane], nodes + m_low[lane], 4);
      const VW word = hn::Load(words, codes);
      const VF share = add(numberOf(hn::And(word, byte)), shareOf(corner), known, sum);
      along.x = hn::MulAdd(share, numberOf(hn::And(hn::ShiftRight<8>(word), byte)), along.x);
      along.y = hn::MulAdd(share, numberOf(hn::And(hn::ShiftRight<16>(word), byte)), along.y);
      along.z = hn::MulAdd(share, numberOf(hn::ShiftRight<24>(word)), along.z);
    }
    const VF per = hn::Div(all(1.0f / 254.0f), safe(known));
    const VF middle = hn::Mul(all(127.0f), known);
    const V3 lean{hn::Mul(per, hn::Sub(along.x, middle)), hn::Mul(per, hn::Sub(along.y, middle)),
                  hn::Mul(per, hn::Sub(along.z, middle))};
    return clamped(hn::Add(mean(sum, known), dot(lean, normal)), 0.0f, 1.0f);
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;

  HWY_INLINE VI lowOf(VF index, int axis, VF& weight) const {
    const auto last = static_cast<float>(m_travel.nodes.count[axis] - 1);
    const VF place =
        clamped(hn::MulAdd(index, all(m_travel.perIndex[axis]), all(m_travel.shift[axis])), 0.0f, last);
    const VF low = hn::Min(hn::Floor(place), all(last - 1.0f));
    weight = hn::Sub(place, low);
    return intOf(low);
  }

  // From the node of the smallest indices.
  HWY_INLINE std::ptrdiff_t stepTo(int corner) const {
    const std::ptrdiff_t row = m_travel.nodes.count.x;
    return (corner & 1) + (corner >> 1 & 1) * row + (corner >> 2) * row * m_travel.nodes.count.y;
  }

  HWY_INLINE VF shareOf(int corner) const {
    const VF x = (corner & 1) != 0 ? m_weight.x : hn::Sub(all(1.0f), m_weight.x);
    const VF y = (corner & 2) != 0 ? m_weight.y : hn::Sub(all(1.0f), m_weight.y);
    const VF z = (corner & 4) != 0 ? m_weight.z : hn::Sub(all(1.0f), m_weight.z);
    return hn::Mul(x, hn::Mul(y, z));
  }

  // Adds what nodes say where they say something; returns their shares there.
  HWY_INLINE static VF add(VF code, VF share, VF& known, VF& sum) {
    const VF own = hn::IfThenElseZero(hn::Gt(code, hn::Zero(floats)), share);
    known = hn::Add(known, own);
    sum = hn::MulAdd(own, code, sum);
    return own;
  }

  HWY_INLINE static VF numberOf(VW byte) { return hn::ConvertTo(floats, hn::BitCast(ints, byte)); }

  HWY_INLINE static VF safe(VF known) {
    return hn::IfThenElse(hn::Gt(known, hn::Zero(floats)), known, all(1.0f));
  }

  // Where no node knows, no light comes.
  HWY_INLINE static VF mean(VF sum, VF known) {
    const VF codes = hn::Div(sum, safe(known));
    return hn::Mul(hn::Max(hn::Sub(codes, all(1.0f)), hn::Zero(floats)), all(1.0f / 254.0f));
  }

  const TravelTerms& m_travel;
  V3 m_weight;
  HWY_ALIGN std::int32_t m_low[most]; // the node of smallest indices around each place
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
