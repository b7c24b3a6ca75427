// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of light to places (DEFINITION section 11) from a coarse grid: what stands near is looked at
// from the place itself, for there M changes within a voxel, and behind it the grid tells.
#if defined(LIMN_CPU_NEAR_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_NEAR_LIGHT_INL_H
#undef LIMN_CPU_NEAR_LIGHT_INL_H
#else
#define LIMN_CPU_NEAR_LIGHT_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/LightGrid-inl.h"
#include "cpu/simd/LightMarch-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// M at several places. Tissue is taken to change along the normal alone as far as three smallest spacings: a
/// few looks along it serve light from all sides. Where nothing near is looked at, it is taken to hide
/// nothing.
template <VoxelSource::Kind kind>
class NearLight {
public:
  /// Normals of unit length, or zero: there all is taken to be as it is at the place.
  HWY_INLINE NearLight(const PictureTerms& terms, const LightMarch<kind>& march, const V3& index,
                       const V3& normal)
      : m_terms(terms), m_march(march), m_index(index), m_normal(normal) {}

  /// Of the light that has a direction: along its middle.
  HWY_NOINLINE VF direct() const {
    const TravelTerms& travel = m_terms.travel;
    const glm::vec3 towards(m_terms.towardsLight);
    const glm::vec3 way = nearLightLengths * towards / glm::vec3(m_terms.spacing);
    const V3 behind{hn::Add(m_index.x, all(way.x)), hn::Add(m_index.y, all(way.y)),
                    hn::Add(m_index.z, all(way.z))};
    const VF far = GridLight(travel, behind).direct();
    if (!travel.looksNear || hn::AllFalse(floats, hn::Gt(far, hn::Zero(floats))))
      return far;
    if (m_terms.effects.has(Effect::isosurface)) { // which is there or not, and met once by a ray
      const Mask every = hn::Ge(all(1.0f), hn::Zero(floats));
      return hn::Mul(
          m_march.transmittance(m_index, all(towards), travel.from, nearLightLengths, 0.25f, every), far);
    }
    const float length = (nearLightLengths - travel.from) / looks;
    VF depth = hn::Zero(floats);
    for (int look = 0; look < looks; ++look) {
      const float at = travel.from + (static_cast<float>(look) + 0.5f) * length;
      depth = hn::MulAdd(m_march.extinctionAlong(m_index, all(towards), at), all(length), depth);
    }
    return hn::Mul(expNeg(depth), far);
  }

  /// Of ambient light.
  HWY_NOINLINE VF ambient() const {
    const TravelTerms& travel = m_terms.travel;
    const glm::vec3 away = layers * thickness / glm::vec3(m_terms.spacing);
    const V3 behind{hn::MulAdd(m_normal.x, all(away.x), m_index.x),
                    hn::MulAdd(m_normal.y, all(away.y), m_index.y),
                    hn::MulAdd(m_normal.z, all(away.z), m_index.z)};
    const VF far = GridLight(travel, behind).ambient(m_normal);
    if (!travel.looksNear)
      return far;
    // Gauss's three points over the square of the cosine.
    constexpr float squares[3] = {0.1127017f, 0.5f, 0.8872983f};
    constexpr float weights[3] = {5.0f / 18.0f, 8.0f / 18.0f, 5.0f / 18.0f};
    const Mask hasNormal = hn::Gt(dot(m_normal, m_normal), all(0.25f));
    VF extinction[layers]; // in the middle of each
    for (int layer = 0; layer < layers; ++layer)
      extinction[layer] =
          m_march.extinctionAlong(m_index, m_normal, (static_cast<float>(layer) + 0.5f) * thickness);
    VF near = hn::Zero(floats);
    for (int i = 0; i < 3; ++i) {
      const float cosine = std::sqrt(squares[i]);
      VF depth = hn::Zero(floats);
      for (int layer = 0; layer < layers; ++layer) {
        const float end = static_cast<float>(layer + 1) * thickness;
        const float counts = std::clamp(end - travel.from * cosine, 0.0f, thickness);
        depth = hn::MulAdd(extinction[layer], all(counts / cosine), depth);
      }
      near = hn::MulAdd(expNeg(depth), all(weights[i]), near);
    }
    // The grid counts from the place on, not from δ on.
    const VF alike = hn::Exp(floats, hn::Mul(hn::Min(extinction[0], all(10.0f)), all(travel.from)));
    return hn::Min(hn::Mul(hn::IfThenElse(hasNormal, near, alike), far), all(1.0f));
  }

private:
  static constexpr int layers = 2;
  static constexpr float thickness = 1.5f; // lengths
  static constexpr int looks = 2;          // along it

  const PictureTerms& m_terms;
  const LightMarch<kind>& m_march;
  V3 m_index, m_normal;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
