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

/// M of DEFINITION section 11 at several places, trilinear between the eight nodes around each. Codes are
/// mixed in 16 bits, two to a lane: that loses less than a twenty-eighth of one.
class GridLight {
public:
  HWY_INLINE GridLight(const LightNodes& nodes, const TravelTerms::ToNodes& to, const V3& index)
      : m_nodes(nodes), m_to(to) {
    VF x, y, z;
    const VI lowX = lowOf(index.x, 0, x), lowY = lowOf(index.y, 1, y), lowZ = lowOf(index.z, 2, z);
    const VI row = hn::Add(hn::Mul(lowZ, hn::Set(ints, nodes.count.y)), lowY);
    hn::Store(hn::Add(hn::Mul(row, hn::Set(ints, nodes.count.x)), lowX), ints, m_low);
    m_upper = {twice(x), twice(y), twice(z)};
    m_lower = {restOf(m_upper.x), restOf(m_upper.y), restOf(m_upper.z)};
  }

  /// Of a light that has a direction.
  HWY_INLINE VF direct(const DirectLight& light) const {
    VH planes[2];
    for (int z = 0; z < 2; ++z) {
      // Neighbours along x are read together; those of the next row stand in the upper half.
      HWY_ALIGN std::uint32_t pairs[most];
      const std::uint8_t* nodes = light.data() + stepTo(0, z);
      const std::uint8_t* next = light.data() + stepTo(1, z);
      for (int lane = 0; lane < lanes(); ++lane) {
        std::uint16_t one = 0, other = 0;
        std::memcpy(&one, nodes + m_low[lane], 2);
        std::memcpy(&other, next + m_low[lane], 2);
        pairs[lane] = one | static_cast<std::uint32_t>(other) << 16;
      }
      const VW codes = hn::Load(words, pairs);
      planes[z] = mixed(evenBytes(codes), oddBytes(codes), m_lower.x, m_upper.x);
    }
    const VH rows = mixed(planes[0], planes[1], m_lower.z, m_upper.z);
    const VW sum = hn::BitCast(words, mixed(rows, nextOf(rows), m_lower.y, m_upper.y));
    // What is lost in rounding must not make less than nothing of it.
    return hn::Max(hn::MulSub(lowHalf(sum), all(1.0f / (254.0f * 256.0f)), all(1.0f / 254.0f)),
                   hn::Zero(floats));
  }

  /// Of ambient light, around normals of unit length, or zero.
  HWY_INLINE VF ambient(const AmbientLight& light, const V3& normal) const {
    VH evens[2], odds[2];
    for (int z = 0; z < 2; ++z) {
      VH even[2], odd[2];
      for (int y = 0; y < 2; ++y) {
        HWY_ALIGN std::uint32_t pairs[2 * most];
        const std::array<std::uint8_t, 4>* nodes = light.data() + stepTo(y, z);
        for (int lane = 0; lane < lanes(); ++lane)
          std::memcpy(&pairs[2 * lane], nodes + m_low[lane], 8);
        VW lower, upper;
        hn::LoadInterleaved2(words, pairs, lower, upper);
        even[y] = mixed(evenBytes(lower), evenBytes(upper), m_lower.x, m_upper.x);
        odd[y] = mixed(oddBytes(lower), oddBytes(upper), m_lower.x, m_upper.x);
      }
      evens[z] = mixed(even[0], even[1], m_lower.y, m_upper.y);
      odds[z] = mixed(odd[0], odd[1], m_lower.y, m_upper.y);
    }
    const VW even = hn::BitCast(words, mixed(evens[0], evens[1], m_lower.z, m_upper.z));
    const VW odd = hn::BitCast(words, mixed(odds[0], odds[1], m_lower.z, m_upper.z));
    // The shares of the axes are nothing without a normal.
    VF sum = hn::MulAdd(normal.x, lowHalf(odd), lowHalf(even));
    sum = hn::MulAdd(normal.y, highHalf(even), sum);
    sum = hn::MulAdd(normal.z, highHalf(odd), sum);
    const VF middle =
        hn::MulAdd(hn::Add(hn::Add(normal.x, normal.y), normal.z), all(127.0f / 254.0f), all(1.0f / 254.0f));
    return clamped(hn::MulSub(sum, all(1.0f / (254.0f * 256.0f)), middle), 0.0f, 1.0f);
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;
  static constexpr hn::Repartition<std::uint16_t, decltype(words)> halves{};
  using VH = hn::Vec<decltype(halves)>;

  struct Weights {
    VH x, y, z; // twice in each lane
  };

  HWY_INLINE VI lowOf(VF index, int axis, VF& weight) const {
    const auto last = static_cast<float>(m_nodes.count[axis] - 1);
    const VF place = clamped(hn::MulAdd(index, all(m_to.perIndex[axis]), all(m_to.shift[axis])), 0.0f, last);
    const VF low = hn::Min(hn::Floor(place), all(last - 1.0f));
    weight = hn::Sub(place, low);
    return intOf(low);
  }

  // From the node of the smallest indices.
  HWY_INLINE std::ptrdiff_t stepTo(int y, int z) const {
    const std::ptrdiff_t row = m_nodes.count.x;
    return y * row + z * row * m_nodes.count.y;
  }

  // In 65535ths, rounded by intOf.
  HWY_INLINE static VH twice(VF weight) {
    const VW whole = hn::BitCast(words, intOf(hn::Mul(weight, all(65535.0f))));
    return hn::BitCast(halves, hn::Or(whole, hn::ShiftLeft<16>(whole)));
  }
  HWY_INLINE static VH restOf(VH weight) { return hn::Sub(hn::Set(halves, 65535), weight); }

  // Codes times 256.
  HWY_INLINE static VH evenBytes(VW codes) { return hn::ShiftLeft<8>(hn::BitCast(halves, codes)); }
  HWY_INLINE static VH oddBytes(VW codes) {
    return hn::BitCast(halves, hn::And(codes, hn::Set(words, 0xff00ff00u)));
  }
  HWY_INLINE static VH nextOf(VH rows) {
    return hn::BitCast(halves, hn::ShiftRight<16>(hn::BitCast(words, rows)));
  }

  HWY_INLINE static VH mixed(VH lower, VH upper, VH shareOfLower, VH shareOfUpper) {
    return hn::Add(hn::MulHigh(lower, shareOfLower), hn::MulHigh(upper, shareOfUpper));
  }

  HWY_INLINE static VF lowHalf(VW pair) { return numberOf(hn::And(pair, hn::Set(words, 0xffffu))); }
  HWY_INLINE static VF highHalf(VW pair) { return numberOf(hn::ShiftRight<16>(pair)); }
  HWY_INLINE static VF numberOf(VW word) { return hn::ConvertTo(floats, hn::BitCast(ints, word)); }

  const LightNodes& m_nodes;
  const TravelTerms::ToNodes& m_to;
  Weights m_lower, m_upper;
  HWY_ALIGN std::int32_t m_low[most]; // the node of smallest indices around each place
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
